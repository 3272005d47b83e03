#include "platform/desktop.h"

#include <windows.h>
// After it, whose words they need.
#include <shellapi.h>
#include <shobjidl.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "platform/environment_variables.h"
#include "platform/windows/wide.h"

namespace weftlight::platform {
namespace {

/// In the program that the user chose for such things.
tl::expected<void, MissingProgram> show(const std::string& path) {
  constexpr INT_PTR kLastError = 32;
  const HINSTANCE shown = ::ShellExecuteW(nullptr, L"open", wide(path).c_str(), nullptr, nullptr, SW_SHOWNORMAL);
  if (reinterpret_cast<INT_PTR>(shown) > kLastError) return {};
  return tl::unexpected(MissingProgram{"explorer"});
}

struct ReleaseOf {
  void operator()(IUnknown* it) const { it->Release(); }
};
template <class T>
using Com = std::unique_ptr<T, ReleaseOf>;

struct Filters {
  std::vector<std::wstring> texts;  // names and patterns by turns
  std::vector<COMDLG_FILTERSPEC> specs;
};
Filters filters_of(const FileQuestion& question) {
  Filters all;
  for (const FileFilter& filter : question.filters) {
    all.texts.push_back(wide(filter.name));
    std::wstring patterns = wide(filter.patterns);
    std::replace(patterns.begin(), patterns.end(), L' ', L';');
    all.texts.push_back(std::move(patterns));
  }
  for (size_t i = 0; i + 1 < all.texts.size(); i += 2)
    all.specs.push_back({all.texts[i].c_str(), all.texts[i + 1].c_str()});
  return all;
}

void propose(IFileDialog& dialog, const FileQuestion& question) {
  if (question.start.empty()) return;
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path folder = fs::absolute(question.start, error).make_preferred();
  if (question.what != FileAsk::kFolder && !fs::is_directory(folder, error)) {
    dialog.SetFileName(folder.filename().wstring().c_str());
    folder = folder.parent_path();
  }
  IShellItem* item = nullptr;
  if (FAILED(::SHCreateItemFromParsingName(folder.wstring().c_str(), nullptr, IID_PPV_ARGS(&item)))) return;
  const Com<IShellItem> owner(item);
  dialog.SetFolder(item);
}

std::optional<std::string> answer_of(IFileDialog& dialog) {
  IShellItem* item = nullptr;
  if (FAILED(dialog.GetResult(&item))) return {};
  const Com<IShellItem> owner(item);
  wchar_t* name = nullptr;
  if (FAILED(item->GetDisplayName(SIGDN_FILESYSPATH, &name))) return {};
  std::string path = narrow(name);
  ::CoTaskMemFree(name);
  return path;
}

/// Waits until the user has answered. On a thread that has begun with CoInitializeEx.
std::optional<std::string> ask_user(const FileQuestion& question) {
  const bool save = question.what == FileAsk::kSave;
  IFileDialog* made = nullptr;
  if (FAILED(::CoCreateInstance(save ? CLSID_FileSaveDialog : CLSID_FileOpenDialog, nullptr, CLSCTX_INPROC_SERVER,
                                IID_PPV_ARGS(&made))))
    return {};
  const Com<IFileDialog> dialog(made);
  DWORD options = 0;
  dialog->GetOptions(&options);
  options |= FOS_FORCEFILESYSTEM;
  if (save) options |= FOS_OVERWRITEPROMPT;
  if (question.what == FileAsk::kFolder) options |= FOS_PICKFOLDERS;
  dialog->SetOptions(options);
  dialog->SetTitle(wide(question.title).c_str());
  const Filters filters = filters_of(question);
  if (!filters.specs.empty()) dialog->SetFileTypes(static_cast<UINT>(filters.specs.size()), filters.specs.data());
  propose(*dialog, question);
  if (FAILED(dialog->Show(nullptr))) return {};  // cancelled
  return answer_of(*dialog);
}

}  // namespace

tl::expected<void, MissingProgram> show_folder(const std::string& folder) { return show(folder); }

tl::expected<void, MissingProgram> show_page(const std::string& file) { return show(file); }

/// Shared with the dialog's thread, which is left to itself when the program ends.
struct FileDialog::Asked {
  struct Answer {
    std::mutex mutex;
    bool given = false;  // guarded by the mutex, as is:
    std::optional<std::string> path;
  };
  std::shared_ptr<Answer> answer = std::make_shared<Answer>();
};

FileDialog::FileDialog() = default;
FileDialog::~FileDialog() = default;

/// WEFTLIGHT_FILE_DIALOG=window asks in the window, as where a system has no dialog: for tests, and where that of
/// Windows fails.
bool FileDialog::is_there() { return variable("WEFTLIGHT_FILE_DIALOG") != "window"; }

void FileDialog::ask(const FileQuestion& question, std::function<void(const std::string&)> chosen) {
  if (waiting()) return;
  asked_ = std::make_unique<Asked>();
  chosen_ = std::move(chosen);
  std::thread([question, answer = asked_->answer] {
    const bool ready = SUCCEEDED(::CoInitializeEx(nullptr, COINIT_APARTMENTTHREADED | COINIT_DISABLE_OLE1DDE));
    std::optional<std::string> path = ready ? ask_user(question) : std::nullopt;
    if (ready) ::CoUninitialize();
    const std::lock_guard lock(answer->mutex);
    answer->path = std::move(path);
    answer->given = true;
  }).detach();
}

void FileDialog::poll() {
  if (!waiting()) return;
  std::optional<std::string> path;
  {
    const std::lock_guard lock(asked_->answer->mutex);
    if (!asked_->answer->given) return;
    path = std::move(asked_->answer->path);
  }
  asked_.reset();
  const auto chosen = std::exchange(chosen_, nullptr);
  if (path && !path->empty()) chosen(*path);
}

}  // namespace weftlight::platform

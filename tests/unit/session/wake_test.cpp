// wake() is called without any lock: the window may answer at once and ask what is new.

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <latch>
#include <string>

#include "../scratch.h"
#include "session/jobs/draft_thumbnails.h"
#include "session/jobs/export_plan.h"
#include "session/jobs/export_preview.h"
#include "session/jobs/exporter.h"
#include "session/loom/loom_link.h"
#include "weaves/weaves.h"

namespace weftlight::session {

using design::Design;
using draft::Face;
using texture_set::TextureSetOptions;
using weaves::Lean, weaves::twill;

namespace {

/// A wake() that asks; under a lock of its owner it would wait for ever.
struct Asking {
  std::function<void()> ask;
  std::latch woken{1};
  std::atomic<bool> first{true};
  std::function<void()> wake() {
    return [this] {
      ask();
      if (first.exchange(false)) woken.count_down();
    };
  }
};

TEST(Wake, IsCalledWithoutALock) {
  const Scratch scratch("wake");
  const auto design = std::make_shared<const Design>(twill({2, 2}, Lean::kRight, {8, 8}));
  {
    Asking a;
    LoomLink link(a.wake());
    a.ask = [&] { link.state(); };
    link.connect(std::string("serial:").append(scratch / "no loom"));
    a.woken.wait();
  }
  {
    Asking a;
    Exporter exporter(a.wake());
    a.ask = [&] { exporter.state(); };
    ExportPlan plan;
    plan.folder = scratch / "out", plan.targets = {&texture_set::targets::kGodot}, plan.size = 32;
    exporter.start(jobs_of(plan, *design, "x.wif", "1"), design);
    a.woken.wait();
  }
  {
    Asking a;
    ExportPreviewer previewer(design, a.wake());
    a.ask = [&] { previewer.take(); };
    TextureSetOptions options;
    options.name = std::string("x"), options.size = 32;
    previewer.ask(Face::kFront, options, {});
    a.woken.wait();
  }
  {
    Asking a;
    DraftThumbnails thumbnails("", a.wake());
    a.ask = [&] { thumbnails.take(); };
    thumbnails.ask(scratch / "none.wif");
    a.woken.wait();
  }
}

}  // namespace
}  // namespace weftlight::session

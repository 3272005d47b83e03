// Programs, variables, folders, lines and pages on Windows.

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "../../unit/catalogue.h"
#include "../../unit/scratch.h"
#include "platform/catalogue.h"
#include "platform/clock.h"
#include "platform/environment_variables.h"
#include "platform/folders.h"
#include "platform/language.h"
#include "platform/line.h"
#include "platform/own_addresses.h"
#include "platform/page_server.h"
#include "platform/process.h"
#include "platform/random_bytes.h"
#include "platform/start.h"

namespace weftlight::platform {
namespace {

using std::chrono::milliseconds;

std::string printed_by(const std::vector<std::string>& words, bool& succeeded) {
  Process program(words);
  EXPECT_TRUE(program.running());
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (program.running() && std::chrono::steady_clock::now() < end) {
    program.look();
    std::this_thread::yield();
  }
  succeeded = program.succeeded();
  return program.output();
}

TEST(StartedProgram, DISABLED_prints_its_words) {
  for (const std::string& word : start(0, nullptr)) std::printf("[%s]", word.c_str());
}

TEST(ProcessOfWindows, words_arrive_as_they_were_given) {
  bool succeeded = false;
  std::vector<std::string> words = {program_folder() + "\\platform_test.exe", "--gtest_also_run_disabled_tests",
                                    "--gtest_filter=StartedProgram.*"};
  std::string wanted;
  for (const char* word : {"a b", "", "\"", "a\\", "a b\\", "\\\"c", "K\xC3\xB6per", "%PATH%", "a&b|c"}) {
    words.emplace_back(word);
    wanted.append("[").append(word).append("]");
  }
  const std::string printed = printed_by(words, succeeded);
  EXPECT_NE(printed.find(wanted), std::string::npos) << printed;
  EXPECT_TRUE(succeeded);
}

TEST(ProcessOfWindows, a_failure_and_a_missing_program_are_told) {
  bool succeeded = true;
  EXPECT_EQ(printed_by({"cmd", "/c", "echo begun& exit 3"}, succeeded).substr(0, 5), "begun");
  EXPECT_FALSE(succeeded);
  EXPECT_FALSE(Process({"no-such-program-71"}).running());
  EXPECT_FALSE(start_program({"no-such-program-71"}));
  EXPECT_TRUE(is_program("cmd", variable("PATH")));
  EXPECT_FALSE(is_program("no-such-program-71", variable("PATH")));
}

TEST(EnvironmentOfWindows, variables_have_all_letters) {
  set_variable("WEFTLIGHT_TEST", "K\xC3\xB6per \xE7\xB9\x94");
  EXPECT_EQ(variable("WEFTLIGHT_TEST"), "K\xC3\xB6per \xE7\xB9\x94");
  set_variable("WEFTLIGHT_TEST", "");
  EXPECT_EQ(variable("WEFTLIGHT_TEST"), "");
}

TEST(FoldersOfWindows, are_the_users_and_the_programs) {
  EXPECT_TRUE(std::filesystem::exists(program_folder() + "/platform_test.exe")) << program_folder();
  for (const std::string& folder : {home_folder(), settings_folder(), state_folder(), cache_folder()})
    EXPECT_TRUE(std::filesystem::path(folder).is_absolute()) << folder;
  EXPECT_NE(state_folder(), cache_folder());
}

TEST(ClockOfWindows, tells_the_time) {
  const std::tm parts = utc_time(1'000'000'000);
  EXPECT_EQ(parts.tm_year, 101);
  EXPECT_EQ(parts.tm_hour, 1);
  EXPECT_GT(processor_ns(), 0);
}

TEST(RandomBytesOfWindows, differ) {
  std::array<uint8_t, 16> one{}, two{};
  EXPECT_TRUE(fill_random(one) && fill_random(two));
  EXPECT_NE(one, two);
}

TEST(NetworkOfWindows, a_page_is_served_over_a_line) {
  EXPECT_EQ(own_addresses().at(0).address, "127.0.0.1");
  const auto server = PageServer::open("127.0.0.1", 0, [](const PageRequest& request, const PageServer::Reply& reply) {
    reply({.status = 200, .type = "text/plain", .body = "you asked for " + request.target});
  });
  ASSERT_TRUE(server) << server.error().message();
  const std::string host = (*server)->host();
  const TcpAddress address{"127.0.0.1", host.substr(host.find(':') + 1)};
  const LineConnected line = LineConnector().connect(address, milliseconds(20000));
  ASSERT_TRUE(line) << line.error().said;
  ASSERT_TRUE((*line)->send("GET /state HTTP/1.1\r\nHost: " + host + "\r\n\r\n"));
  std::string heard;
  while (!(*line)->broken() && heard.find("/state") == std::string::npos)
    heard += (*line)->receive(milliseconds(20000));
  EXPECT_EQ(heard.substr(0, 12), "HTTP/1.1 200");
  EXPECT_NE(heard.find("you asked for /state"), std::string::npos) << heard;
}

TEST(NetworkOfWindows, a_port_that_is_not_there_is_told) {
  const LineConnected line = LineConnector().connect(SerialAddress{"COM250"}, milliseconds(1000));
  ASSERT_FALSE(line);
  EXPECT_EQ(line.error().problem, LineProblem::kNoSuchPort) << line.error().said;
}

TEST(LanguageOfWindows, speaks_without_gettext) {
  const Scratch folder;
  std::filesystem::create_directories(folder / "de/LC_MESSAGES");
  std::ofstream(folder / "de/LC_MESSAGES/weftlight.mo", std::ios::binary)
      << catalogue_of({{"", "Language: de\nPlural-Forms: nplurals=2; plural=(n != 1);\n"},
                       {"Open",
                        "\xC3\x96"
                        "ffnen"},
                       {std::string("{n} pick\0{n} picks", 18), std::string("{n} Schuss\0{n} Sch\xC3\xBCsse", 23)}});
  use_language("de_AT", folder.folder.string());
  EXPECT_EQ(catalogue_language(), "de");
  EXPECT_STREQ(translated("Open"),
               "\xC3\x96"
               "ffnen");
  EXPECT_STREQ(translated("{n} pick", "{n} picks", 1), "{n} Schuss");
  EXPECT_STREQ(translated("{n} pick", "{n} picks", 2), "{n} Sch\xC3\xBCsse");
  EXPECT_STREQ(translated("Close"), "Close");
  use_language("en", folder.folder.string());
  EXPECT_STREQ(translated("Open"), "Open");
  EXPECT_STREQ(translated("{n} pick", "{n} picks", 2), "{n} picks");
}

}  // namespace
}  // namespace weftlight::platform

// The page for a phone: pairing, what it refuses, its steps, and requests in pieces, too long or none at all.

#include "loom/phone_page.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace weftlight::loom {

using platform::PageRequestReader;

namespace {

/// Bytes that differ from call to call, and from run to run do not.
PhonePage::RandomBytes counted() {
  return [next = uint8_t{0}](std::span<uint8_t> bytes) mutable {
    for (uint8_t& byte : bytes) byte = next++;
    return true;
  };
}

constexpr const char* kHost = "192.168.1.5:7389";

struct PhonePageTest : testing::Test {
  PhonePage page{kHost, counted()};

  PageRequest get(const std::string& target) const { return {"GET", target, kHost, {}, {}, cookie, {}, {}}; }
  PageRequest post(const std::string& target, const std::string& body) const {
    return {"POST", target, kHost, std::string("http://") + kHost, {}, cookie, {}, body};
  }
  static std::string field(const PageAnswer& answer, const std::string& name) {
    for (const auto& [key, value] : answer.fields)
      if (key == name) return value;
    return {};
  }
  void pair() {
    const auto outcome = page.take(post("/pair", "code=" + page.code()));
    ASSERT_TRUE(outcome.answer);
    ASSERT_EQ(outcome.answer->status, 303);
    const std::string set = field(*outcome.answer, "Set-Cookie");
    EXPECT_NE(set.find("HttpOnly; SameSite=Strict"), std::string::npos) << set;
    cookie = set.substr(0, set.find(';'));
  }
  std::string at() const { return "at=" + std::to_string(page.revision()); }

  std::string cookie{};
};

TEST_F(PhonePageTest, ShowsNothingWithoutTheCode) {
  page.show({.title = "Secret cloth", .heading = "Pick", .number = "7", .of = "of 9", .what = "Treadle 3"});
  const auto first = page.take(get("/"));
  ASSERT_TRUE(first.answer);
  EXPECT_EQ(first.answer->body.find("Secret"), std::string::npos);
  EXPECT_EQ(first.answer->body.find(page.code()), std::string::npos);
  for (const char* target : {"/state", "/cloth.png"}) EXPECT_EQ(page.take(get(target)).answer->status, 403);
  EXPECT_EQ(page.take(post("/next", at())).answer->status, 403);
  cookie = "weftlight=" + std::string(64, '0');
  EXPECT_EQ(page.take(get("/state")).answer->status, 403) << "a token that nobody was given";
  cookie.clear();
  ASSERT_NO_FATAL_FAILURE(pair());
  EXPECT_NE(page.take(get("/")).answer->body.find("Secret cloth"), std::string::npos);
}

TEST_F(PhonePageTest, ACodePairsOneBrowserAndWrongOnesAreCounted) {
  const std::string code = page.code();
  EXPECT_EQ(code.size(), 6u);
  ASSERT_NO_FATAL_FAILURE(pair());
  EXPECT_NE(page.code(), code) << "used";
  cookie.clear();
  for (int i = 0; i < PhonePage::kMaxTries; ++i)
    EXPECT_EQ(page.take(post("/pair", "code=" + code)).answer->status, 403);
  EXPECT_TRUE(page.code().empty()) << "pairing is closed";
  EXPECT_EQ(page.take(post("/pair", "code=")).answer->status, 403) << "an empty code is none";
  page.renew_code();
  ASSERT_NO_FATAL_FAILURE(pair());
  EXPECT_EQ(page.paired(), 2u) << "the one before stays";
  for (size_t i = 2; i < PhonePage::kMaxPaired; ++i) {
    cookie.clear();
    ASSERT_NO_FATAL_FAILURE(pair());
  }
  cookie.clear();
  EXPECT_EQ(page.take(post("/pair", "code=" + page.code())).answer->status, 403) << "as many as may be";
}

TEST_F(PhonePageTest, OtherNamesAndOtherPagesAreRefused) {
  ASSERT_NO_FATAL_FAILURE(pair());
  PageRequest request = get("/");
  for (const char* host : {"evil.example:7389", "192.168.1.5", "", "localhost:7389"}) {
    request.host = host;
    EXPECT_EQ(page.take(request).answer->status, 421) << host;
  }
  request = post("/next", at());
  for (const char* origin : {"http://evil.example", "null", "http://192.168.1.5:80", "https://192.168.1.5:7389"}) {
    request.origin = origin;
    const auto outcome = page.take(request);
    EXPECT_FALSE(outcome.step) << origin;
    EXPECT_EQ(outcome.answer->status, 403) << origin;
  }
  request.origin.clear();
  EXPECT_EQ(page.take(request).answer->status, 403) << "neither origin nor referrer";
  request.referer = std::string("http://") + kHost + "/";
  EXPECT_EQ(page.take(request).step, PhoneStep::kNext) << "an old browser";
  request = get("/next");
  EXPECT_FALSE(page.take(request).step) << "a link moves nothing";
  request.method = "DELETE";
  EXPECT_EQ(page.take(request).answer->status, 405);
}

TEST_F(PhonePageTest, EveryAnswerHasTheHeadOfAPageInALocalNetwork) {
  ASSERT_NO_FATAL_FAILURE(pair());
  page.show({.title = "<b>\"{{script}}'&", .heading = "Pick"});
  for (const char* target : {"/", "/state", "/nothing", "/cloth.png"}) {
    const PageAnswer answer = *page.take(get(target)).answer;
    EXPECT_EQ(field(answer, "X-Content-Type-Options"), "nosniff") << target;
    EXPECT_EQ(field(answer, "Referrer-Policy"), "same-origin");
    EXPECT_EQ(field(answer, "Cache-Control"), "no-store");
    EXPECT_TRUE(field(answer, "Content-Security-Policy").starts_with("default-src 'none'")) << target;
  }
  const PageAnswer answer = *page.take(get("/")).answer;
  EXPECT_NE(answer.body.find("&lt;b&gt;&quot;&#123;&#123;script}}&#39;&amp;"), std::string::npos)
      << "texts are no HTML";
  const std::string policy = field(answer, "Content-Security-Policy");
  const size_t nonce = policy.find("'nonce-") + 7;
  EXPECT_NE(answer.body.find("<script nonce=\"" + policy.substr(nonce, 32)), std::string::npos);
  EXPECT_EQ(answer.body.find(" style="), std::string::npos) << "the policy allows no style of an element";
  EXPECT_NE(answer.body.find("<html lang=\"en\">"), std::string::npos) << "so that it is read aloud in its language";
  EXPECT_EQ(answer.body.find("{{"), std::string::npos) << "something was not filled in";
  EXPECT_NE(field(*page.take(get("/")).answer, "Content-Security-Policy"), policy) << "each answer has its own";
}

TEST_F(PhonePageTest, AStepIsTakenOnceFromWhatWasShown) {
  ASSERT_NO_FATAL_FAILURE(pair());
  page.show({.title = {}, .heading = "Pick", .number = "1"});
  const std::string from = at();
  const auto outcome = page.take(post("/next", from));
  EXPECT_FALSE(outcome.answer) << "it waits until the step is made";
  EXPECT_EQ(outcome.step, PhoneStep::kNext);
  page.show({.title = {}, .heading = "Pick", .number = "2"});
  EXPECT_EQ(page.answer_waiting(post("/next", from)).status, 303);
  const auto again = page.take(post("/next", from));
  EXPECT_FALSE(again.step) << "sent twice";
  EXPECT_NE(again.answer->body.find("has moved on"), std::string::npos);
  EXPECT_EQ(page.take(post("/tabby", at())).answer->status, 404) << "this threading has none";
  EXPECT_FALSE(page.take(get("/state?after=" + std::to_string(page.revision()))).answer) << "nothing new yet";
  EXPECT_NE(page.take(get("/state?after=1")).answer->body.find("\"number\":\"2\""), std::string::npos);
}

TEST_F(PhonePageTest, WithoutRandomNumbersNobodyIsPaired) {
  PhonePage none(kHost, [](std::span<uint8_t>) { return false; });
  EXPECT_TRUE(none.code().empty());
  EXPECT_EQ(none.take(post("/pair", "code=")).answer->status, 403);
}

TEST(Secrets, AreComparedToTheEnd) {
  EXPECT_TRUE(same_secret("482913", "482913"));
  for (const char* other : {"482914", "082913", "", "4829130", "48291"}) EXPECT_FALSE(same_secret("482913", other));
}

TEST(PageRequests, InPiecesAndTooLong) {
  const std::string bytes =
      "POST /next?x HTTP/1.1\r\nHost: a:1\r\nOrigin: http://a:1\r\nCookie: weftlight=1\r\nContent-Length: "
      "4\r\n\r\nat=7";
  PageRequestReader whole;
  ASSERT_EQ(whole.read(bytes), PageRequestReader::State::kDone);
  EXPECT_EQ(whole.request().target, "/next?x");
  EXPECT_EQ(whole.request().body, "at=7");
  PageRequestReader pieces;
  for (const char byte : bytes) pieces.read({&byte, 1});
  EXPECT_EQ(pieces.request().cookie, "weftlight=1");
  const auto status = [](const std::string& request) {
    PageRequestReader reader;
    return reader.read(request) == PageRequestReader::State::kRefused ? reader.status() : 0;
  };
  EXPECT_EQ(status("GET /" + std::string(100000, 'a')), 431);
  EXPECT_EQ(status("GET / HTTP/1.1\r\nA: " + std::string(20000, 'b')), 431);
  EXPECT_EQ(status("POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 2000000000\r\n\r\n"), 413);
  EXPECT_EQ(status("POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n1\r\n"), 411);
  EXPECT_EQ(status("GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n"), 400) << "which of the two?";
  EXPECT_EQ(status(std::string("\x16\x03\x01\x02\0\x01", 6)), 400) << "a browser that wants https";
}

}  // namespace
}  // namespace weftlight::loom

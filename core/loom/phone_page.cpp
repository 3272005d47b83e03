#include "loom/phone_page.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/json.h"
#include "base/text.h"

namespace weftlight::loom {

using base::arg, base::fill, base::tr, base::tr_in, base::tr_n;

namespace {

constexpr const char* kHtml = "text/html; charset=utf-8";
constexpr const char* kCookie = "weftlight=";
constexpr size_t kTokenBytes = 32, kNonceBytes = 16;

std::string hex_of(std::span<const uint8_t> bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const uint8_t byte : bytes) text.append({kDigits[byte >> 4], kDigits[byte & 15]});
  return text;
}

/// As many bytes in hexadecimal digits; empty if the system gives none.
std::string secret(const PhonePage::RandomBytes& random, size_t bytes) {
  std::vector<uint8_t> filled(bytes);
  return random(filled) ? hex_of(filled) : std::string();
}

/// Text in HTML, between tags and in attributes in double quotes.
std::string html(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      case '{':  // filled_page looks for these
        out += "&#123;";
        break;
      default:
        out += c;
    }
  return out;
}

/// Replaces each {{NAME}} of a page; the values are HTML already.
std::string filled_page(std::string_view pattern, const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string out;
  while (!pattern.empty()) {
    const size_t begin = pattern.find("{{"), end = pattern.find("}}", begin);
    if (end == std::string_view::npos) break;
    out.append(pattern.substr(0, begin));
    const std::string_view name = pattern.substr(begin + 2, end - begin - 2);
    for (const auto& [key, value] : values)
      if (key == name) out.append(value);
    pattern.remove_prefix(end + 2);
  }
  return out.append(pattern);
}

/// The value of a field of a form; empty if there is none. Only digits and letters are asked for, so none is escaped.
std::string form_field(std::string_view form, std::string_view name) {
  while (!form.empty()) {
    const std::string_view field = form.substr(0, form.find('&'));
    if (field.starts_with(name) && field.size() > name.size() && field[name.size()] == '=')
      return std::string(field.substr(name.size() + 1));
    form.remove_prefix(std::min(field.size() + 1, form.size()));
  }
  return {};
}

uint64_t number_in(const std::string& text) {
  uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc{} && read.ptr == text.data() + text.size() ? number : 0;
}

bool wants_state(const PageRequest& request) { return request.accept == "application/json"; }

std::string_view path_of(const PageRequest& request) {
  return std::string_view(request.target).substr(0, request.target.find('?'));
}

std::string_view query_of(const PageRequest& request) {
  const size_t mark = request.target.find('?');
  return mark == std::string::npos ? std::string_view() : std::string_view(request.target).substr(mark + 1);
}

PageAnswer redirect() { return {303, {}, {}, {{"Location", "/"}}}; }

std::string box(size_t number, bool filled) {
  return fill("<li{up}>{number}</li>", arg("up", filled ? " class=\"up\"" : ""), arg("number", number));
}

std::string color_row(const PhoneShown::Color& color) {
  // A style attribute would need a policy that allows them all.
  return "<li><svg viewBox=\"0 0 1 1\" aria-hidden=\"true\"><rect width=\"1\" height=\"1\" fill=\"" + html(color.hex) +
         "\"/></svg><span>" + html(color.text) + "</span></li>";
}

std::string revision_text(uint64_t revision) { return std::to_string(revision); }

/// The fields that every answer has. The referrer stays within the page: with none at all, browsers would not name the
/// origin of its own forms either.
PageAnswer with_security(PageAnswer answer) {
  for (const auto& [name, value] :
       std::initializer_list<std::pair<const char*, const char*>>{{"X-Content-Type-Options", "nosniff"},
                                                                  {"X-Frame-Options", "DENY"},
                                                                  {"Referrer-Policy", "same-origin"},
                                                                  {"Cross-Origin-Opener-Policy", "same-origin"},
                                                                  {"Cross-Origin-Resource-Policy", "same-origin"},
                                                                  {"Cache-Control", "no-store"}})
    answer.fields.emplace_back(name, value);
  if (answer.fields.front().first != "Content-Security-Policy")
    answer.fields.emplace_back("Content-Security-Policy", "default-src 'none'; frame-ancestors 'none'");
  return answer;
}

constexpr std::string_view kFrame = R"html(<!doctype html>
<html lang="{{lang}}"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1,viewport-fit=cover">
<meta name="color-scheme" content="light dark"><title>Weftlight</title>
<style nonce="{{nonce}}">{{style}}</style></head>
<body>{{body}}</body></html>
)html";

constexpr std::string_view kPairing = R"html(<main class="pair"><h1>Weftlight</h1>
<p class="remark" role="alert">{{sentence}}</p>
<form method="post" action="/pair"><label for="code">{{ask}}</label>
<input id="code" name="code" inputmode="numeric" pattern="[0-9 ]*" maxlength="7" autocomplete="one-time-code" autofocus required>
<button class="next">{{pair}}</button></form></main>)html";

constexpr std::string_view kStep = R"html(<main id="page" data-revision="{{revision}}" data-lost="{{lost}}">
<header><h1 id="title">{{title}}</h1><button id="speak" type="button" aria-pressed="false" hidden>{{speak}}</button></header>
<p id="remark" class="remark" role="alert">{{remark}}</p>
<section id="step" aria-live="polite"><p id="heading">{{heading}}</p>
<p class="count"><strong id="number">{{number}}</strong> <span id="of">{{of}}</span></p>
<p id="group">{{group}}</p><p id="what">{{what}}</p>
<ol id="shafts">{{shafts}}</ol><ul id="colors">{{colors}}</ul></section>
<figure id="cloth"{{no_cloth}}><img id="picture" src="/cloth.png?{{revision}}" alt="{{cloth}}"><figcaption id="progress">{{progress}}</figcaption></figure>
<nav><form method="post" action="/back"><input type="hidden" name="at" value="{{revision}}"><button>{{back}}</button></form>
<form method="post" action="/tabby"{{no_tabby}}><input type="hidden" name="at" value="{{revision}}"><button>{{tabby}}</button></form>
<form method="post" action="/next"><input type="hidden" name="at" value="{{revision}}"><button class="next">{{next}}</button></form></nav>
<noscript><p class="note"><a href="/">{{again}}</a></p></noscript></main>
<script nonce="{{nonce}}">{{script}}</script>)html";

}  // namespace

bool same_secret(const std::string& a, const std::string& b) {
  unsigned differs = a.size() == b.size() ? 0 : 1;
  for (size_t i = 0; i < a.size(); ++i)
    differs |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(i < b.size() ? b[i] : 0);
  const volatile unsigned all = differs;  // so that no compiler ends the loop early
  return all == 0;
}

PhonePage::PhonePage(std::string host, RandomBytes random) : host_(std::move(host)), random_(std::move(random)) {
  renew_code();
}

void PhonePage::renew_code() {
  code_.clear();
  wrong_ = 0;
  constexpr uint32_t kCodes = 1000000, kFair = 0xffffffffu / kCodes * kCodes;
  std::array<uint8_t, 4> bytes{};
  for (int attempt = 0; attempt < 100 && code_.empty(); ++attempt) {
    if (!random_(bytes)) return;
    uint32_t number = 0;
    for (const uint8_t byte : bytes) number = number << 8 | byte;
    if (number >= kFair) continue;  // the codes below the remainder would come more often
    code_ = std::to_string(number % kCodes);
    code_.insert(0, static_cast<size_t>(kCodeDigits) - code_.size(), '0');
  }
}

void PhonePage::show(PhoneShown shown) {
  if (shown == shown_) return;
  shown_ = std::move(shown);
  ++revision_;
}

PageAnswer PhonePage::page(int status, const std::string& body) const {
  const std::string nonce = secret(random_, kNonceBytes);
  PageAnswer answer{status, kHtml,
                    filled_page(filled_page(kFrame, {{"nonce", "{{nonce}}"},
                                                     {"style", kPhoneStyle},
                                                     {"body", body},
                                                     {"lang", html(tr_in("code of this language", "en"))}}),
                                {{"nonce", nonce}, {"script", kPhoneScript}})};
  // Without a nonce neither style nor script would run; the page does without.
  const std::string own = nonce.empty() ? "'none'" : "'nonce-" + nonce + "'";
  answer.fields = {
      {"Content-Security-Policy", "default-src 'none'; style-src " + own + "; script-src " + own +
                                      "; img-src 'self'; connect-src 'self'; form-action 'self'; base-uri 'none'; "
                                      "frame-ancestors 'none'"}};
  return answer;
}

PageAnswer PhonePage::plain(int status, const std::string& sentence) const {
  return {status, "text/plain; charset=utf-8", sentence + "\n"};
}

PageAnswer PhonePage::pairing_page(int status, const std::string& sentence) const {
  return page(status, filled_page(kPairing, {{"sentence", html(sentence)},
                                             {"ask", html(tr("Enter the code shown in the loom view"))},
                                             {"pair", html(tr("Pair"))}}));
}

PageAnswer PhonePage::step_page(const std::string& sentence) const {
  std::string shafts, colors;
  for (size_t i = 0; i < shown_.shafts.size(); ++i) shafts += box(i + 1, shown_.shafts[i]);
  for (const PhoneShown::Color& color : shown_.colors) colors += color_row(color);
  return page(200, filled_page(kStep, {{"nonce", "{{nonce}}"},
                                       {"script", "{{script}}"},
                                       {"revision", revision_text(revision_)},
                                       {"title", html(shown_.title)},
                                       {"remark", html(sentence.empty() ? shown_.remark : sentence)},
                                       {"heading", html(shown_.heading)},
                                       {"number", html(shown_.number)},
                                       {"of", html(shown_.of)},
                                       {"group", html(shown_.group)},
                                       {"what", html(shown_.what)},
                                       {"progress", html(shown_.progress)},
                                       {"shafts", shafts},
                                       {"colors", colors},
                                       {"cloth", html(tr("The cloth as woven so far"))},
                                       {"no_cloth", shown_.cloth ? "" : " hidden"},
                                       {"no_tabby", shown_.can_tabby ? "" : " hidden"},
                                       {"lost", html(tr("Weftlight is not responding"))},
                                       {"again", html(tr("Show the current step"))},
                                       {"speak", html(tr("Speak"))},
                                       {"back", html(tr_in("a step", "Back"))},
                                       {"tabby", html(tr("Tabby"))},
                                       {"next", html(tr("Next"))}}));
}

PageAnswer PhonePage::state_answer() const {
  nlohmann::json colors = nlohmann::json::array();
  for (const PhoneShown::Color& color : shown_.colors) colors.push_back({{"hex", color.hex}, {"text", color.text}});
  const nlohmann::json state{
      {"revision", revision_},           {"title", shown_.title},       {"remark", shown_.remark},
      {"heading", shown_.heading},       {"number", shown_.number},     {"of", shown_.of},
      {"group", shown_.group},           {"what", shown_.what},         {"progress", shown_.progress},
      {"shafts", shown_.shafts},         {"colors", std::move(colors)}, {"tabby", shown_.can_tabby},
      {"cloth", shown_.cloth != nullptr}};
  return {200, "application/json", state.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

bool PhonePage::is_paired(const PageRequest& request) const {
  std::string_view cookies = request.cookie;
  bool paired = false;
  while (!cookies.empty()) {
    const std::string_view cookie = cookies.substr(0, cookies.find(';'));
    const size_t begin = std::min(cookie.find_first_not_of(' '), cookie.size());
    if (const std::string_view named = cookie.substr(begin); named.starts_with(kCookie)) {
      const std::string token(named.substr(std::string_view(kCookie).size()));
      for (const std::string& known : tokens_) paired |= same_secret(known, token);
    }
    cookies.remove_prefix(std::min(cookie.size() + 1, cookies.size()));
  }
  return paired;
}

PageAnswer PhonePage::pair(const PageRequest& request) {
  if (is_paired(request)) return redirect();
  if (tokens_.size() >= kMaxPaired)
    return pairing_page(403, tr("No more devices can be paired. Stop the page and start it again."));
  if (code_.empty()) return pairing_page(403, tr("Pairing is closed. Ask for a new code in the loom view."));
  std::string typed = form_field(request.body, "code");
  std::erase_if(typed, [](char c) { return c == ' ' || c == '+'; });
  if (!same_secret(code_, typed)) {
    const int left = kMaxTries - ++wrong_;
    if (left > 0)
      return pairing_page(403, fill(tr_n("That is not the code. {count} try is left.",
                                         "That is not the code. {count} tries are left.", left),
                                    arg("count", left)));
    code_.clear();
    return pairing_page(403, tr("Pairing is closed after too many wrong codes. Ask for a new code in the loom view."));
  }
  const std::string token = secret(random_, kTokenBytes);
  if (token.empty()) return pairing_page(500, tr("The system provides no random numbers, so no device can be paired."));
  tokens_.push_back(token);
  renew_code();
  PageAnswer answer = redirect();
  answer.fields.emplace_back("Set-Cookie", kCookie + token + "; Path=/; HttpOnly; SameSite=Strict");
  return answer;
}

PhonePage::Outcome PhonePage::get(const PageRequest& request) const {
  const std::string_view path = path_of(request);
  if (path == "/") return {is_paired(request) ? step_page({}) : pairing_page(200, {})};
  if (path != "/state" && path != "/cloth.png") return {plain(404, tr("There is no such page."))};
  if (!is_paired(request)) return {plain(403, tr("This device is not paired."))};
  if (path == "/cloth.png") {
    if (!shown_.cloth) return {plain(404, tr("There is no such page."))};
    return {PageAnswer{200, "image/png", *shown_.cloth}};
  }
  // Until something else is shown the answer waits.
  if (number_in(form_field(query_of(request), "after")) == revision_) return {};
  return {state_answer()};
}

PhonePage::Outcome PhonePage::post(const PageRequest& request) {
  // A browser names the page that a form or a script came from. Old ones give only the referrer.
  const std::string own = "http://" + host_;
  const bool same = request.origin.empty() ? request.referer.starts_with(own + "/") : request.origin == own;
  if (!same) return {plain(403, tr("The request came from another page."))};
  const std::string_view path = path_of(request);
  if (path == "/pair") return {pair(request)};
  std::optional<PhoneStep> step;
  if (path == "/next") step = PhoneStep::kNext;
  if (path == "/back") step = PhoneStep::kBack;
  if (path == "/tabby" && shown_.can_tabby) step = PhoneStep::kTabby;
  if (!step) return {plain(404, tr("There is no such page."))};
  if (!is_paired(request)) return {plain(403, tr("This device is not paired."))};
  // Asked twice, or from a page that was left open: nothing moves, and the present step is shown.
  if (number_in(form_field(request.body, "at")) != revision_)
    return {wants_state(request) ? state_answer()
                                 : step_page(tr("The weaving has moved on; this is the current step."))};
  return {{}, step};
}

PhonePage::Outcome PhonePage::take(const PageRequest& request) {
  Outcome outcome;
  // A name that another site has given to this address would let its pages read this one.
  if (request.host != host_) outcome = {plain(421, fill(tr("This page is at http://{host}/."), arg("host", host_)))};
  else if (request.method == "GET") outcome = get(request);
  else if (request.method == "POST") outcome = post(request);
  else outcome = {plain(405, tr("There is no such page."))};
  if (outcome.answer) *outcome.answer = with_security(std::move(*outcome.answer));
  return outcome;
}

PageAnswer PhonePage::answer_waiting(const PageRequest& request) const {
  return with_security(request.method == "POST" && !wants_state(request) ? redirect() : state_answer());
}

}  // namespace weftlight::loom

#include "platform/page_request.h"

#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

namespace weftlight::platform {

namespace http = boost::beast::http;

struct PageRequestReader::Parser {
  http::request_parser<http::string_body> of_beast;
};

namespace {

int status_of(const boost::system::error_code& error) {
  if (error == http::error::header_limit) return 431;
  if (error == http::error::body_limit) return 413;
  return 400;
}

using Fields = http::request<http::string_body>;

/// The value of a field; false if it comes twice, of which programs between could each believe another.
bool read_field(const Fields& head, http::field name, std::string& value) {
  const auto [first, end] = head.equal_range(name);
  if (first == end) return true;
  value = std::string(first->value());
  return std::next(first) == end;
}

const char* reason_of(int status) {
  return http::obsolete_reason(static_cast<http::status>(status)).data();  // a literal
}

}  // namespace

std::string answer_bytes(const PageAnswer& answer) {
  std::string bytes = "HTTP/1.1 " + std::to_string(answer.status) + " " + reason_of(answer.status) + "\r\n";
  const auto add = [&bytes](std::string_view name, std::string_view value) {
    bytes.append(name).append(": ").append(value).append("\r\n");
  };
  add("Connection", "close");
  if (answer.status != 204) add("Content-Length", std::to_string(answer.body.size()));
  if (!answer.type.empty()) add("Content-Type", answer.type);
  for (const auto& [name, value] : answer.fields) add(name, value);
  return bytes.append("\r\n").append(answer.body);
}

PageRequestReader::PageRequestReader() : parser_(std::make_unique<Parser>()) {
  parser_->of_beast.eager(true);
  parser_->of_beast.header_limit(kMaxHead);
  parser_->of_beast.body_limit(kMaxBody);
}

PageRequestReader::~PageRequestReader() = default;

PageRequestReader::State PageRequestReader::refused(int status) {
  status_ = status;
  waiting_.clear();
  return state_ = State::kRefused;
}

PageRequestReader::State PageRequestReader::read(std::string_view bytes) {
  auto& parser = parser_->of_beast;
  while (state_ == State::kMore && !bytes.empty()) {
    // A part at a time, so that no more waits than a head may have.
    const std::string_view part = bytes.substr(0, 1 + kMaxHead - std::min(waiting_.size(), kMaxHead));
    waiting_.append(part);
    bytes.remove_prefix(part.size());
    bool again = true;
    while (again && !waiting_.empty() && !parser.is_done()) {
      boost::system::error_code error;
      const size_t taken = parser.put(boost::asio::buffer(waiting_), error);
      waiting_.erase(0, taken);
      again = taken > 0;
      if (error == http::error::need_more) again = false;
      else if (error) return refused(status_of(error));
      // A body in chunks has no length that could be refused beforehand.
      if (parser.is_header_done() && parser.chunked()) return refused(411);
    }
    if (parser.is_done()) return done();
    if (waiting_.size() > kMaxHead) return refused(431);
  }
  return state_;
}

PageRequestReader::State PageRequestReader::done() {
  const Fields& head = parser_->of_beast.get();
  request_.method = std::string(head.method_string());
  request_.target = std::string(head.target());
  const bool once =
      read_field(head, http::field::host, request_.host) & read_field(head, http::field::origin, request_.origin) &
      read_field(head, http::field::referer, request_.referer) & read_field(head, http::field::cookie, request_.cookie);
  if (!once) return refused(400);
  request_.accept = std::string(head[http::field::accept]);
  request_.body = head.body();
  waiting_.clear();
  return state_ = State::kDone;
}

}  // namespace weftlight::platform

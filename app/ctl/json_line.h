// SPDX-License-Identifier: GPL-3.0-or-later
// One JSON object on a line, key after key. Every subcommand on a live interface speaks in these; the keys
// are a frozen contract (README, "deckpipectl").
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/ids.h"
#include "report/json.h"

namespace deckpipe::ctl {

class JsonLine {
 public:
  JsonLine& add(std::string_view key, std::string_view text) {
    appendJsonString(begin(key), text);
    return *this;
  }
  JsonLine& add(std::string_view key, const char* text) { return add(key, std::string_view(text)); }
  JsonLine& add(std::string_view key, std::int64_t number) {
    appendJsonNumber(begin(key), number);
    return *this;
  }
  // `number`: decimal text, which is inserted without quotes.
  JsonLine& addNumber(std::string_view key, std::string_view number) {
    begin(key) += number;
    return *this;
  }
  JsonLine& add(std::string_view key, bool flag) {
    begin(key) += flag ? "true" : "false";
    return *this;
  }
  JsonLine& add(std::string_view key, const Value& value) {
    appendJsonValue(begin(key), value);
    return *this;
  }
  JsonLine& add(std::string_view key, const std::vector<std::string_view>& words) {
    std::string& text = begin(key) += '[';
    for (bool isFirst = true; const std::string_view word : words) {
      if (!std::exchange(isFirst, false)) text += ',';
      appendJsonString(text, word);
    }
    text += ']';
    return *this;
  }
  // Writes null for a null PIN or address.
  JsonLine& add(std::string_view key, const Pin& pin) {
    return pin.isNull() ? add(key, Value()) : add(key, pin.text());
  }
  JsonLine& add(std::string_view key, Address address) {
    return address == kNullAddress ? add(key, Value()) : add(key, std::int64_t{address.value});
  }
  // Nanoseconds since 1970 as seconds.
  JsonLine& addTime(std::string_view key, std::int64_t ns) {
    appendJsonSeconds(begin(key), ns);
    return *this;
  }
  // The keys of another whole object of one line, line feed or not.
  JsonLine& addAllOf(std::string_view object) {
    const std::size_t end = object.rfind('}');
    m_text += m_text.empty() ? "{" : ",";
    m_text += object.substr(1, end - 1);
    return *this;
  }
  std::string text() const { return m_text + "}\n"; }

 private:
  std::string& begin(std::string_view key) {
    m_text += m_text.empty() ? "{\"" : ",\"";
    return m_text.append(key) += "\":";
  }
  std::string m_text;
};

}  // namespace deckpipe::ctl

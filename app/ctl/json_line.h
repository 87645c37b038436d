// SPDX-License-Identifier: GPL-3.0-or-later
// One JSON object on a line, key after key. Every subcommand on a live interface speaks in these; the keys
// are a frozen contract (README, "deckpipectl").
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "base/ids.h"
#include "protocol/device_types.h"
#include "report/json.h"

namespace deckpipe::ctl {

class JsonLine {
 public:
  JsonLine& add(std::string_view key, std::string_view text) {
    appendJsonString(begin(key), text);
    return *this;
  }
  JsonLine& add(std::string_view key, const char* text) { return add(key, std::string_view(text)); }
  template <std::integral T>
  JsonLine& add(std::string_view key, T number) {
    appendJsonNumber(begin(key), static_cast<std::int64_t>(number));
    return *this;
  }
  // `json`: a number, a list or an object as it is written.
  JsonLine& addJson(std::string_view key, std::string_view json) {
    begin(key) += json;
    return *this;
  }
  JsonLine& addHex(std::string_view key, std::uint64_t number, unsigned digits) {
    begin(key) += '"';
    appendHex(m_text, number, digits);
    m_text += '"';
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
    std::vector<std::string> list(words.size());
    for (std::size_t i = 0; i < words.size(); ++i) appendJsonString(list[i], words[i]);
    return addList(key, list);
  }
  // `items`: each as it is written.
  JsonLine& addList(std::string_view key, const std::vector<std::string>& items) {
    begin(key) += '[';
    for (const std::string& item : items) m_text.append(&item == &items.front() ? "" : ",").append(item);
    m_text += ']';
    return *this;
  }
  // Writes null for a null PIN or address.
  JsonLine& add(std::string_view key, const Pin& pin) {
    return pin.isNull() ? add(key, Value()) : add(key, pin.text());
  }
  JsonLine& add(std::string_view key, Address address) {
    return address == kNullAddress ? add(key, Value()) : add(key, address.value);
  }
  // device_type and type_name of a device with this PIN; nothing of one without.
  JsonLine& addTypeOf(const Pin& pin) {
    if (pin.isNull()) return *this;
    const std::string_view type = deviceTypeName(pin.deviceType());
    add("device_type", pin.deviceType());
    return type.empty() ? add("type_name", Value()) : add("type_name", type);
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
  std::string object() const { return (m_text.empty() ? "{" : m_text) + '}'; }
  std::string text() const { return object() + '\n'; }

 private:
  std::string& begin(std::string_view key) {
    m_text += m_text.empty() ? "{\"" : ",\"";
    return m_text.append(key) += "\":";
  }
  std::string m_text;
};

}  // namespace deckpipe::ctl

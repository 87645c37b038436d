// SPDX-License-Identifier: GPL-3.0-or-later
#include "device_finder.h"

#include "arguments.h"
#include "command.h"
#include "protocol/device_types.h"

namespace deckpipe::ctl {
namespace {

QString latin1(std::string_view text) {
  return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace

void DeviceFinder::begin() {
  m_since.start();
  request();
}

void DeviceFinder::request() {
  m_asked = m_since.elapsed();
  m_run.session().intend(intent::RequestNames{});
}

std::vector<DeviceServices> DeviceFinder::devices() const {
  std::vector<DeviceServices> found;
  for (const DeviceServices& device : m_run.services().devices) {
    if (device.address == kNullAddress) continue;
    if (m_name.pin && device.device != DeviceKey::of(*m_name.pin)) continue;
    if (m_name.address && device.address != *m_name.address) continue;
    found.push_back(device);
  }
  return found;
}

bool DeviceFinder::hasFound() {
  if (m_hasFound) return true;
  const std::vector<DeviceServices> found = devices();
  // An answer may get lost on a busy bus.
  if (m_since.elapsed() - m_asked >= kAskAgain) request();
  const bool heardEveryone = m_since.elapsed() >= kHearEveryone;
  // An address alone may yet turn out to be a PIN's.
  const bool isCertain =
      m_name.pin || (m_name.address && !found.empty() && found[0].device.kind == DeviceKey::Kind::Pin);
  m_hasFound = !found.empty() && (isCertain || heardEveryone);
  if (!m_hasFound && m_since.elapsed() >= kPatience) {
    m_run.say(whyNotFound());
    m_run.finish(kNotWhole);
  }
  return m_hasFound;
}

QString DeviceFinder::whyNotFound() const {
  const State& state = m_run.follower().state();
  const AddressBook& book = state.channel(m_run.channel()).book;
  if (m_name.address && !book.holder(*m_name.address).isNull())
    return QStringLiteral("%1 is held by %2, which takes nothing of this")
        .arg(m_name.text(), nameText(book.holder(*m_name.address)));
  if (m_name.address && book.isHeard(*m_name.address))
    return m_name.text() + QStringLiteral(" is not known to be a device that takes this");
  const Device* device = m_name.pin ? state.devices().byPin(m_run.channel(), *m_name.pin) : nullptr;
  if (device != nullptr && device->address == kNullAddress)
    return m_name.text() + QStringLiteral(" has no address any more: another node took it");
  return m_name.pin || m_name.address ? m_name.text() + QStringLiteral(" is not heard on this bus")
                                      : QStringLiteral("no device is heard on this bus");
}

QString nameText(Name name) {
  return QStringLiteral("NAME %1").arg(name.value, 16, 16, QLatin1Char('0')).toUpper();
}

QString deviceText(const DeviceServices& device) {
  const QString address = QStringLiteral("address ") + addressText(device.address);
  if (device.device.pin.isNull()) return QStringLiteral("the device at ") + address;
  const std::string_view type = deviceTypeName(device.device.pin.deviceType());
  return QStringLiteral("%1 (%2) at %3")
      .arg(latin1(device.device.pin.text()), type.empty() ? QStringLiteral("type not known") : latin1(type),
           address);
}

}  // namespace deckpipe::ctl

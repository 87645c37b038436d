// SPDX-License-Identifier: GPL-3.0-or-later
// What a tooltip of the device table tells of one device, in sentences.
#pragma once

#include <QString>
#include <QStringList>
#include <string_view>

#include "base/device_key.h"
#include "model/device_labels.h"
#include "state/log_view.h"

namespace deckpipe {

// "can0"; empty where the log has one channel only, for then there is nothing to tell apart.
QString channelText(const LogView& view, Channel channel);
// "80 hex for 12 s"; "lost 3 s ago, it was 80 hex"
QString addressNow(const State& state, const Device& device);
// The addresses before, the latest first: "81 hex until 12 s ago". Empty where there were none.
QStringList addressesBefore(const State& state, const Device& device);
// The key of the word for a claim (text/catalogue_text.h).
std::string_view claimKey(ClaimState claim);
// "2 won, 1 lost"; empty where there were none.
QString contestText(const AddressBook& book, Address address);

QString detailsText(const LogView& view, const DeviceKey& key, const DeviceLabels& labels = {});

}  // namespace deckpipe

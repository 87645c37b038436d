// SPDX-License-Identifier: GPL-3.0-or-later
// Who is at an address, rule by rule (protocol.md 1.3, "Who holds an address").
#include "protocol/address_book.h"

#include <gtest/gtest.h>

#include <sstream>

#include "protocol/classify.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

// L < A < B < M < H. A is the NAME of PIN P, B that of Q; the others are of another maker.
struct Known {
  char letter;
  const char* bytes;  // of the NAME, or of the announcement
};
constexpr Known kNames[] = {{'L', "0100200000000000"}, {'A', "0B1AC22800420090"}, {'B', "0C1AC22800420090"},
                            {'M', "02002001000000FE"}, {'H', "01002001000000FF"}, {'0', "0000000000000000"}};
constexpr Known kPins[] = {{'P', "FF83150206021A0B"}, {'Q', "FF83150206021A0C"}};

const char* bytesOf(char letter) {
  for (const Known& known : kNames) {
    if (known.letter == letter) return known.bytes;
  }
  for (const Known& known : kPins) {
    if (known.letter == letter) return known.bytes;
  }
  std::abort();
}

// A channel told as words: "80=A" the NAME A claims 80, "FE=A" it cannot claim, "80!P" the PIN P is announced
// there, "80#" a status of Akron's, "F9?" a request for NAMEs, "80~" any other frame, "80+d" and "80-d" the person says a drive or takes it back, "+250" so many
// milliseconds, "+1n" so many nanoseconds.
class Script {
 public:
  explicit Script(std::string_view words, bool hasTimes = true)
      : m_now(hasTimes ? Instant{1'000'000'000} : Instant{}), m_hasTimes(hasTimes) {
    std::istringstream in{std::string(words)};
    for (std::string word; in >> word;) play(word);
  }

  const AddressBook& book() const { return m_book; }
  // What is known of an address; its holder first, "-" for nobody.
  std::string of(unsigned number) const {
    const Address a{static_cast<std::uint8_t>(number)};
    std::string text(1, '-');
    for (const Known& known : kNames) {
      if (known.letter != '0' && m_book.holder(a) == Name::of(test::frame("18EEFF80", known.bytes)))
        text = known.letter;
    }
    constexpr const char* kStates[] = {"no_claim", "claiming", "claimed", "contested", "cannot_claim"};
    text += std::string(" ") + kStates[static_cast<std::size_t>(m_book.claim(a, m_now))];
    if (m_book.isAkron(a)) text += " akron";
    if (m_book.isForeign(a)) text += " foreign";
    if (m_book.isDrive(a)) text += " drive";
    if (m_book.wasLeft(a)) text += " left";
    if (m_book.sharedSince(a, m_now) != kNotYet) text += " two";
    const Pin pin = m_book.pin(a);
    if (!pin.isNull()) text += pin.text().back() == '5' ? " P" : " Q";
    if (m_book.claimsWon(a) != 0) text += " won" + std::to_string(m_book.claimsWon(a));
    if (m_book.claimsLost(a) != 0) text += " lost" + std::to_string(m_book.claimsLost(a));
    return text;
  }
  // The addresses that the last word took from their device, in hex.
  std::string lost() const {
    std::ostringstream out;
    for (std::size_t i = 0; i < m_lost.size(); ++i) {
      if (m_lost[i]) out << (out.str().empty() ? "" : " ") << std::hex << i;
    }
    return out.str();
  }

 private:
  void play(const std::string& word) {
    m_lost.reset();
    if (word.front() == '+') {
      const std::int64_t number = std::strtoll(word.c_str() + 1, nullptr, 10);
      m_now = m_now + (word.back() == 'n' ? Duration(number) : Duration(number * 1'000'000));
      m_book.timeCame(m_now, m_lost);
      return;
    }
    const std::string address = word.substr(0, 2);
    switch (word.at(2)) {
      case '=': return hear("18EEFF" + address, bytesOf(word.at(3)));
      case '!': return hear("18EFFF" + address, bytesOf(word.at(3)));
      case '#': return hear("18EFFF" + address, "83C051");
      case '?': return hear("18EAFF" + address, "00EE00");
      case '~': return hear("18FF00" + address, "00");
      default:
        m_book.sayDrive({static_cast<std::uint8_t>(std::strtoul(address.c_str(), nullptr, 16))},
                        word.at(2) == '+');
    }
  }
  void hear(const std::string& id, const char* data) {
    const Frame frame = test::frame(id, data, 0, m_hasTimes ? m_now.ns : kNoStamp);
    m_book.timeCame(m_now, m_lost);
    m_book.observe(frame, m_now, classify(frame, m_now, m_book), m_lost);
  }

  AddressBook m_book;
  AddressBook::Lost m_lost;
  Instant m_now;
  bool m_hasTimes;
};

struct Row {
  const char* name;
  const char* script;
  const char* at80;
};
void check(std::span<const Row> rows, bool hasTimes = true) {
  for (const Row& row : rows) EXPECT_EQ(Script(row.script, hasTimes).of(0x80), row.at80) << row.name;
}

TEST(AddressBook, KnowsWhoHoldsAnAddress) {
  const Row rows[] = {
      {"nobody was heard", "", "- no_claim"},
      {"heard without a NAME", "80~", "- no_claim"},
      {"the first NAME heard holds", "80=H", "H claiming foreign"},
      {"claiming until 250 ms", "80=H +249 +999999n", "H claiming foreign"},
      {"claimed after 250 ms", "80=H +250", "H claimed foreign"},
      {"the same NAME again changes nothing", "80=A +1000 80=A", "A claimed akron"},
      {"a lower NAME takes it at once", "80=H +1000 80=A", "A claiming akron lost1"},
      {"also while the higher is claiming", "80=H +10 80=L", "L claiming foreign lost1"},
      {"NAME 0 means nothing", "80=0", "- no_claim"},
      {"NAME 0 is no lower NAME", "80=A +1000 80=0", "A claimed akron"},
      {"a claim from the global address means nothing", "80=A +1000 FF=A FF=L", "A claimed akron"},
      {"the holder claims another address, too", "80=A +1000 81=A", "A claimed akron"},
  };
  check(rows);
}

TEST(AddressBook, DecidesContests) {
  const Row rows[] = {
      {"a higher NAME contests", "80=A +1000 80=H", "A contested akron"},
      {"until 250 ms", "80=A +1000 80=H +249 +999999n", "A contested akron"},
      {"won by an answer", "80=A +1000 80=H +100 80=A", "A claimed akron won1"},
      {"won for good", "80=A +1000 80=H +100 80=A +1000", "A claimed akron won1"},
      {"won in the last nanosecond", "80=A +1000 80=H +249 +999999n 80=A", "A claimed akron won1"},
      {"lost for want of an answer", "80=A +1000 80=H +250", "H claimed foreign lost1"},
      {"an answer too late takes it back, if lower", "80=A +1000 80=H +250 80=A", "A claiming akron lost2"},
      {"another frame is no answer", "80=A +1000 80=H +100 80~ +150", "H claimed foreign lost1"},
      {"the same claim again begins nothing anew", "80=A +1000 80=H +200 80=H +50",
       "H claimed foreign lost1"},
      {"the lower of two challengers has it", "80=A +1000 80=H +100 80=M +150", "M claimed foreign lost1"},
      {"in whatever order they come", "80=A +1000 80=M +100 80=H +150", "M claimed foreign lost1"},
      {"one answer wins against two", "80=A +1000 80=M 80=H +10 80=A +1000", "A claimed akron won1"},
      {"a lower NAME ends it", "80=A +1000 80=H +10 80=L +1000", "L claimed foreign lost1"},
      {"a challenger that claims elsewhere gave up", "80=A +1000 80=H +10 81=H +1000", "A claimed akron"},
      {"a challenger that cannot claim gave up", "80=A +1000 80=H FE=H +1000", "A claimed akron"},
      {"the former holder contests in its turn", "80=B +1000 80=A 80=B +249", "A contested akron lost1"},
      {"and returns if it is not answered", "80=B +1000 80=A 80=B +250", "B claimed akron two lost2"},
      {"two contests one after the other", "80=A 80=H 80=A +10 80=M +250", "M claimed foreign won1 lost1"},
  };
  check(rows);
}

TEST(AddressBook, LeavesAnAddressToADeviceWhoseStatusesGoOn) {
  const Row rows[] = {
      {"against a lower NAME", "80=A 80# +1000 80=L +90 80# +100 80# +60", "A contested akron two"},
      {"against a higher one", "80=A 80# +1000 80=H +90 80# +100 80# +60", "A contested akron two"},
      {"of a PIN alone", "80!P 80# +1000 80=L +90 80# +100 80# +60", "- contested akron two P"},
      {"of nobody known", "80# +1000 80=L +90 80# +100 80# +60", "- contested two"},
      {"they are not two at once", "80=A 80# +1000 80=L +90 80# +100 80#", "A contested akron"},
      {"asked meanwhile", "80# +1000 80=L +90 80# +100 80# +60 F9? 80=L", "- contested two"},
      {"answers are no victory", "80=A 80# 80=L +90 80# +100 80# +60 80=A", "A contested akron two"},
      {"until they stop", "80=A 80# 80=L +90 80# +100 80# +1999", "A contested akron two"},
      {"when they have stopped", "80=A 80# 80=L +90 80# +100 80# +2000", "L claimed foreign lost1"},
      {"for as long as they come", "80=A 80# 80=L +90 80# +100 80# +1900 80# +1900 80#",
       "A contested akron two"},
      {"none comes", "80=A 80# 80=L +250", "L claimed foreign lost1"},
      {"one comes that was under way", "80=A 80# 80=L +10 80# +240", "L claimed foreign lost1"},
      {"one comes twice", "80=A 80# 80=L +10 80# +40 80# +200", "L claimed foreign lost1"},
      {"none came before", "80=A 80=L +90 80# +100 80#", "L claiming foreign lost1"},
      {"they came before another NAME", "80=A 80# 80=L +250 80=H +90 80# +100 80# +60",
       "H claimed foreign lost2"},
      {"a NAME that was asked for may be the sender's", "80# F9? +20 80=L +90 80# +100 80#",
       "L claiming foreign"},
      {"a NAME of Akron's", "80=B 80# 80=A +90 80# +100 80#", "A claiming akron lost1"},
      {"the device goes elsewhere", "80=A 80# 80=L +10 81=A", "L claiming foreign lost1"},
      {"the device cannot claim", "80=A 80# 80=L +10 FE=A", "L claiming foreign lost1"},
      {"the other one goes elsewhere", "80=A 80# 80=L +90 80# +100 80# +60 81=L", "A claimed akron"},
      {"the other one cannot claim", "80# 80=L +90 80# +100 80# +60 FE=L", "- no_claim"},
      {"the device contests in its turn", "80=A 80# 80=L 80=A", "L contested foreign lost1"},
  };
  check(rows);
}

TEST(AddressBook, GivesAnAddressToAHigherNameAtOnceInALogWithoutTimes) {
  const Row rows[] = {
      {"higher", "80=A 80=H", "H claiming foreign lost1"},
      {"lower", "80=H 80=A", "A claiming akron lost1"},
      {"the same", "80=A 80=A", "A claiming akron"},
  };
  check(rows, false);
}

TEST(AddressBook, FreesWhatItsHolderCannotClaim) {
  const Row rows[] = {
      {"freed", "80=A FE=A", "- cannot_claim"},
      {"another's is not", "80=A FE=H", "A claiming akron"},
      {"the next has it at once, though higher", "80=A FE=A 80=H", "H claiming foreign"},
      {"and so has the former holder", "80=A FE=A 80=A", "A claiming akron"},
      {"who contested it has it", "80=A +1000 80=H +10 FE=A", "H claiming foreign lost1"},
      {"the PIN has left, too", "80=A 80!P FE=A", "- cannot_claim"},
  };
  check(rows);
  const Script both("80=A 81=A FE=A");
  EXPECT_EQ(both.of(0x80), "- cannot_claim");
  EXPECT_EQ(both.of(0x81), "- cannot_claim");
  EXPECT_EQ(both.lost(), "80 81");
}

TEST(AddressBook, KeepsADriveUntilAnotherNameTakesTheAddress) {
  const Row rows[] = {
      {"said of nobody", "80+d", "- no_claim drive"},
      {"taken back", "80+d 80-d", "- no_claim"},
      {"its first NAME", "80+d 80=H", "H claiming foreign drive"},
      {"its NAME again", "80=H 80+d 80=H", "H claiming foreign drive"},
      {"a lower NAME", "80=H 80+d 80=L", "L claiming foreign lost1"},
      {"a contest", "80=A 80+d 80=H", "A contested akron drive"},
      {"a contest won", "80=A 80+d 80=H 80=A", "A claiming akron drive won1"},
      {"a contest lost", "80=A 80+d 80=H +250", "H claimed foreign lost1"},
      {"said after a contest was lost", "80=A 80=H +250 80+d", "H claimed foreign drive lost1"},
      {"cannot claim", "80=H 80+d FE=H", "- cannot_claim drive"},
      {"and then its NAME again", "80=H 80+d FE=H 80=H", "H claiming foreign drive"},
      {"and then another", "80=H 80+d FE=H 80=M", "M claiming foreign"},
      {"an announcement", "80+d 80!P", "- no_claim akron drive P"},
  };
  check(rows);
}

TEST(AddressBook, KnowsThePinThatWasAnnouncedThere) {
  const Row rows[] = {
      {"without a NAME", "80!P", "- no_claim akron P"},
      {"its own NAME comes later", "80!P 80=A", "A claiming akron P"},
      {"its own NAME came before", "80=A 80!P", "A claiming akron P"},
      {"another Akron NAME comes first", "80!P 80=B", "B claiming akron"},
      {"another maker's NAME comes first", "80!P 80=H", "H claiming foreign"},
      {"another NAME takes it", "80=A 80!P 80=L", "L claiming foreign lost1"},
      {"contested", "80=A 80!P 80=H", "A contested akron P"},
      {"the contest is lost", "80=A 80!P 80=H +250", "H claimed foreign lost1"},
      {"another PIN", "80!P 80!Q", "- no_claim akron Q"},
      {"it moves", "80!P 81!P", "- no_claim akron left"},
      {"somebody is heard there", "80!P 81!P 80~", "- no_claim akron"},
      {"it comes back", "80!P 81!P 80!P", "- no_claim akron P"},
      {"a foreign source announces nothing", "80=H 80!P", "H claiming foreign"},
      {"nor does the null address", "FE!P", "- no_claim"},
  };
  check(rows);
  EXPECT_EQ(Script("80!P 81!P").of(0x81), "- no_claim akron P");
}

TEST(AddressBook, SaysWhichAddressesTheirDeviceLost) {
  const Row rows[] = {
      {"first NAME, Akron's", "80~ 80=A", ""},
      {"first NAME, another maker's", "80~ 80=H", "80"},
      {"the same NAME again", "80=A 80=A", ""},
      {"a lower NAME", "80=H 80=A", "80"},
      {"a contest is open", "80=A 80=H", ""},
      {"a contest is won", "80=A 80=H 80=A", ""},
      {"a contest is lost", "80=A 80=H +250", "80"},
      {"its own NAME", "80!P 80=A", ""},
      {"a NAME it cannot have", "80!P 80=B", "80"},
      {"first PIN", "80=A 80!P", ""},
      {"another PIN", "80!P 80!Q", "80"},
      {"a PIN moves", "80!P 81!P", "80"},
      {"a PIN moves to another's place", "80!P 81!Q 81!P", "80 81"},
      {"cannot claim", "80=A FE=A", "80"},
      {"cannot claim, and the one whose PIN is there takes it", "80=A +1000 80!Q 80=B FE=A", ""},
  };
  for (const Row& row : rows) EXPECT_EQ(Script(row.script).lost(), row.at80) << row.name;
}

TEST(AddressBook, KnowsWhoWasHeardThoughWithoutANameAndWithoutAMeaning) {
  const Script script("80~ 81=0 FF~ FE~");
  EXPECT_TRUE(script.book().isHeard({0x80}));
  EXPECT_TRUE(script.book().isHeard({0x81}));
  EXPECT_FALSE(script.book().isHeard({0x82}));
  EXPECT_FALSE(script.book().isHeard(kGlobalAddress));
  EXPECT_FALSE(script.book().isHeard(kNullAddress));
}

TEST(AddressBook, LeavesAddressesToTheirHoldersWhereTooManyAreContested) {
  std::string words, claims;
  for (unsigned a = 0x80; a < 0x90; ++a) {
    char word[6];
    std::snprintf(word, sizeof word, "%02X=A ", a);
    words += word;
  }
  // By NAMEs of their own: one that claims elsewhere has given up.
  Script script(words + "+1000");
  AddressBook book = script.book();
  AddressBook::Lost lost;
  const Instant now{5'000'000'000};
  for (unsigned a = 0x80; a < 0x90; ++a) {
    Frame claim = test::frame("18EEFF80", bytesOf('H'), 0, now.ns);
    claim.id = (claim.id & ~0xFFu) | a;
    claim.data[0] = static_cast<std::uint8_t>(a);
    book.observe(claim, now, classify(claim, now, book), lost);
  }
  EXPECT_TRUE(book.timeCame(now + kClaimTime, lost));
  EXPECT_EQ(lost.count(), 8u);
  EXPECT_FALSE(book.isContested({0x8F}));
  EXPECT_TRUE(book.holder({0x8F}).isAkron());
  EXPECT_EQ(book.nextDecision(), kNever);
}

TEST(AddressBook, DecidesAtTheLastInstantThereIs) {
  AddressBook book;
  AddressBook::Lost lost;
  const Instant end{std::numeric_limits<std::int64_t>::max() - 1};
  for (const char letter : {'A', 'H'}) {
    const Frame claim = test::frame("18EEFF80", bytesOf(letter), 0, end.ns);
    book.observe(claim, end, classify(claim, end, book), lost);
  }
  EXPECT_TRUE(book.isContested({0x80}));
  EXPECT_TRUE(book.timeCame(kNever, lost));
  EXPECT_FALSE(book.isContested({0x80}));
}

TEST(IdentityNumber, IsTheLowBitsOfThePinsSerial) {
  const Pin pin = *Pin::parse("1032AE100801035");
  EXPECT_EQ(identityOf(pin), 100801035u & 0x1FFFFFu);
  EXPECT_EQ(Name::of(test::frame("18EEFF80", bytesOf('A'))).identityNumber(), identityOf(pin));
  EXPECT_TRUE(isNameOf(Name::of(test::frame("18EEFF80", bytesOf('A'))), pin));
  EXPECT_FALSE(isNameOf(Name::of(test::frame("18EEFF80", bytesOf('B'))), pin));
  EXPECT_EQ(kLargestIdentity, 0x1FFFFFu);
}

}  // namespace
}  // namespace deckpipe

// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/whole_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <cerrno>

namespace {

// What happens when fsync() is called of a folder.
struct Disk {
  ino_t folder = 0;
  int fault = 0;            // it fails with this errno
  QStringList namesThen{};  // the files in the folder then
  QString path{};
};
Disk* s_disk = nullptr;

}  // namespace

// The program calls this one instead of the C library's.
extern "C" int fsync(int file) {
  struct stat facts {};
  if (s_disk != nullptr && ::fstat(file, &facts) == 0 && facts.st_ino == s_disk->folder) {
    s_disk->namesThen = QDir(s_disk->path).entryList(QDir::Files, QDir::Name);
    errno = s_disk->fault;
    if (errno != 0) return -1;
  }
  return static_cast<int>(::syscall(SYS_fsync, file));
}

namespace deckpipe {
namespace {

class WholeFileTest : public testing::Test {
 protected:
  WholeFileTest() {
    struct stat facts {};
    EXPECT_EQ(::stat(QFile::encodeName(m_dir.path()).constData(), &facts), 0);
    m_disk.folder = facts.st_ino;
    m_disk.path = m_dir.path();
    s_disk = &m_disk;
  }
  ~WholeFileTest() override { s_disk = nullptr; }

  QTemporaryDir m_dir;
  QTemporaryDir m_other;
  Disk m_disk;
};

TEST_F(WholeFileTest, ItsNameIsOnTheDiskToo) {
  WholeFile file(m_dir.filePath(QStringLiteral("a.log")));
  EXPECT_TRUE(file.open() && file.write("x") && file.commit());
  EXPECT_EQ(m_disk.namesThen, QStringList{QStringLiteral("a.log")});
}

TEST_F(WholeFileTest, OfALinkTheNameOfWhatItLeadsToIs) {
  const QString link = m_other.filePath(QStringLiteral("link.log"));
  QFile target(m_dir.filePath(QStringLiteral("a.log")));
  ASSERT_TRUE(target.open(QIODevice::WriteOnly) && target.link(link));
  WholeFile file(link);
  EXPECT_TRUE(file.open() && file.write("x") && file.commit());
  EXPECT_EQ(m_disk.namesThen, QStringList{QStringLiteral("a.log")});
}

TEST_F(WholeFileTest, SaysWhyItsNameIsNotOnTheDisk) {
  m_disk.fault = EIO;
  WholeFile file(m_dir.filePath(QStringLiteral("a.log")));
  EXPECT_TRUE(file.open() && file.write("x"));
  EXPECT_FALSE(file.commit());
  EXPECT_EQ(file.reason(), QStringLiteral("Input/output error"));
}

TEST_F(WholeFileTest, AFileSystemThatCannotBeToldIsNoFault) {
  m_disk.fault = EINVAL;
  WholeFile file(m_dir.filePath(QStringLiteral("a.log")));
  EXPECT_TRUE(file.open() && file.write("x") && file.commit()) << file.reason().toStdString();
}

}  // namespace
}  // namespace deckpipe

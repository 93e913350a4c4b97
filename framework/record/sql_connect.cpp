// SPDX-License-Identifier: Apache-2.0
#include "record/sql_connect.hpp"

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QtCore/QUrl>
#include <QtCore/QUrlQuery>
#include <QtCore/QVariant>
#include <QtSql/QSqlDatabase>
#include <QtSql/QSqlDriver>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "record/address.hpp"
#include "record/sentences.hpp"

namespace swage::record {
namespace {

// Creates folders with 0700 and an empty file with 0600, before SQLite creates its files with the rights of this process. The file
// is created without being opened: SQLite's locks belong to the whole process, and closing any descriptor of a file that is open
// elsewhere in this program would drop them.
bool make_private_file(const std::string& path, std::string& error) {
  namespace fs = std::filesystem;
  std::error_code code;
  std::vector<fs::path> missing;
  for (fs::path p = fs::absolute(path, code).parent_path(); !p.empty() && !fs::exists(p, code);
       p = p.parent_path())
    missing.push_back(p);
  for (auto p = missing.rbegin(); p != missing.rend(); ++p) {
    if (mkdir(p->c_str(), 0700) == 0 || errno == EEXIST) continue;
    error = "The folder " + p->string() + " cannot be made: " + std::strerror(errno) + ".";
    return false;
  }
  if (mknod(path.c_str(), S_IFREG | 0600, 0) == 0) return true;
  if (errno == EEXIST && ::access(path.c_str(), R_OK | W_OK) == 0) return true;
  error = path + " cannot be opened for writing: " + std::strerror(errno) + ".";
  return false;
}

// True when no program can change the file: in a read-only folder with an empty log, where SQLite cannot create its shared memory.
bool is_frozen(const std::string& where) {
  struct stat log {};
  const std::string folder = std::filesystem::path(where).parent_path().string();
  return ::access(folder.empty() ? "." : folder.c_str(), W_OK) != 0 &&
         (stat((where + "-wal").c_str(), &log) != 0 || log.st_size == 0);
}

}  // namespace

// postgresql://user:password@host:port/database?host=/folder/of/the/socket, and libpq's options for encryption. False with a
// sentence for any other part: an option for encryption must not be ignored.
bool configure_postgres(QSqlDatabase& db, const std::string& where, std::string& error) {
  const QUrl url(QString::fromStdString(where));
  const QUrlQuery query(url);
  QString host = url.host(), user = url.userName(), password = url.password(), options;
  int port = url.port();
  if (!url.isValid()) {
    error = shown(where) + " is no address: " + without_password(url.errorString().toStdString(), where) +
            ". In a password, write @ : / ? # as %40 %3A %2F %3F %23.";
    return false;
  }
  for (const auto& [key, value] : query.queryItems(QUrl::FullyDecoded)) {
    if (key == QLatin1String("host")) host = value;
    else if (key == QLatin1String("port")) port = value.toInt();
    else if (key == QLatin1String("user")) user = value;
    else if (key == QLatin1String("password")) password = value;
    else if (key.startsWith(QLatin1String("ssl")) || key == QLatin1String("passfile"))
      options += QStringLiteral(";%1=%2").arg(key, value);
    else {
      error = say::kNoPartOfAddress(shown(where), key.toStdString());
      return false;
    }
  }
  db.setHostName(host);
  db.setUserName(user);
  db.setPassword(password);
  db.setDatabaseName(url.path().mid(1));
  if (port > 0) db.setPort(port);
  db.setConnectOptions(QStringLiteral("connect_timeout=3") + options);
  return true;
}

// Checks that the file of an SQLite store can be written or read; creates it for writing. Devices and pipes are refused
// before they are opened, which could block for ever.
bool file_ready(const std::string& where, Access access, std::string& error, Trouble& why) {
  struct stat facts {};
  const bool there = stat(where.c_str(), &facts) == 0;
  const bool good = !there || S_ISREG(facts.st_mode);
  if (!good) error = say::kNotAFile(where);
  bool ready = good && access == Access::kWrite && make_private_file(where, error);
  if (good && access == Access::kRead) {
    ready = ::access(where.c_str(), R_OK) == 0;
    if (!ready) error = where + " cannot be read: " + std::strerror(errno) + ".";
  }
  if (ready || !good) return ready;
  why = errno == ENOSPC                                          ? Trouble::kFull
        : errno == EACCES || errno == EROFS || errno == EPERM ? Trouble::kReadOnly
                                                                 : Trouble::kOther;
  return false;
}

void configure_sqlite(QSqlDatabase& db, const std::string& where, Access access) {
  // 2000 ms: longer than any measured commit, shorter than the time that the recorder's ring holds
  QString options = QStringLiteral("QSQLITE_BUSY_TIMEOUT=2000");
  QString name = QString::fromStdString(where);
  if (access == Access::kRead) {
    options += QStringLiteral(";QSQLITE_OPEN_READONLY");
    if (is_frozen(where)) {
      QUrl url = QUrl::fromLocalFile(QString::fromStdString(std::filesystem::absolute(where).string()));
      url.setQuery(QStringLiteral("immutable=1"));
      name = url.toString(QUrl::FullyEncoded);
      options += QStringLiteral(";QSQLITE_OPEN_URI");
    }
  }
  db.setDatabaseName(name);
  db.setConnectOptions(options);
}

// The socket of a connection of Qt's driver, -1 when unknown. The driver has loaded libpq; a station without a server
// does not need libpq.
int socket_of(const QSqlDatabase& db) {
  const QVariant handle = db.driver()->handle();
  void* library = dlopen("libpq.so.5", RTLD_NOW | RTLD_NOLOAD);
  if (library == nullptr || !handle.isValid()) return -1;
  const auto ask = reinterpret_cast<int (*)(const void*)>(dlsym(library, "PQsocket"));
  const int socket = ask != nullptr ? ask(*static_cast<void* const*>(handle.constData())) : -1;
  dlclose(library);
  return socket;
}

}  // namespace swage::record

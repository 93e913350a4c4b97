// SPDX-License-Identifier: Apache-2.0
#include "record/sql.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QtCore/QByteArray>
#include <QtCore/QMetaType>
#include <QtCore/QUrl>
#include <QtCore/QUrlQuery>
#include <QtCore/QVariant>
#include <QtSql/QSqlDatabase>
#include <QtSql/QSqlError>
#include <QtSql/QSqlQuery>
#include <QtSql/QSqlRecord>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>

namespace swage::record {
namespace {

QVariant to_qt(const Value& value) {
  struct Visit {
    QVariant operator()(std::monostate) const { return QVariant(QMetaType(QMetaType::QString)); }
    QVariant operator()(int64_t v) const { return QVariant(static_cast<qlonglong>(v)); }
    QVariant operator()(double v) const {
      return std::isnan(v) ? QVariant(QMetaType(QMetaType::Double)) : QVariant(v);
    }
    QVariant operator()(const std::string& v) const { return QVariant(QString::fromStdString(v)); }
    QVariant operator()(const Blob& v) const {
      // without a pointer it would be NULL, which is not the same as empty
      if (v.empty()) return QVariant(QByteArray("", 0));
      return QVariant(QByteArray(reinterpret_cast<const char*>(v.data()), static_cast<qsizetype>(v.size())));
    }
  };
  return std::visit(Visit{}, value);
}

Value from_qt(const QVariant& value) {
  if (value.isNull()) return std::monostate{};
  switch (value.typeId()) {
    case QMetaType::Int:
    case QMetaType::UInt:
    case QMetaType::LongLong:
    case QMetaType::ULongLong:
    case QMetaType::Bool:
      return static_cast<int64_t>(value.toLongLong());
    case QMetaType::Double:
      return value.toDouble();
    case QMetaType::QByteArray: {
      const QByteArray bytes = value.toByteArray();
      return Blob(bytes.begin(), bytes.end());
    }
    default:
      return value.toString().toStdString();
  }
}

// the low byte of SQLite's extended result codes; PostgreSQL's codes are five letters, class 53 is lack of
// resources
Trouble classify(const QSqlError& error, bool postgres) {
  if (error.type() == QSqlError::NoError) return Trouble::kNone;
  if (postgres) {
    const QString code = error.nativeErrorCode();
    if (code.startsWith(QLatin1String("53"))) return Trouble::kFull;
    return code == QLatin1String("55P03") ? Trouble::kLocked : Trouble::kOther;
  }
  switch (error.nativeErrorCode().toInt() & 0xff) {
    case 5:  // SQLITE_BUSY
    case 6:  // SQLITE_LOCKED
      return Trouble::kLocked;
    case 10:  // SQLITE_IOERR: also a file over the size that the system allows
    case 13:  // SQLITE_FULL
      return Trouble::kFull;
    case 11:  // SQLITE_CORRUPT
    case 26:  // SQLITE_NOTADB
      return Trouble::kDamaged;
    default:
      return Trouble::kOther;
  }
}

// folders 0700 and an empty file 0600, before SQLite makes its own with the rights of this process
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
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) {
    error = path + " cannot be opened for writing: " + std::strerror(errno) + ".";
    return false;
  }
  close(file);
  return true;
}

QString unique_name() {
  static std::atomic<uint64_t> count{0};
  return QStringLiteral("swage_record_%1").arg(++count);
}

// postgresql://user:password@host:port/database?host=/folder/of/the/socket
void configure_postgres(QSqlDatabase& db, const std::string& where) {
  const QUrl url(QString::fromStdString(where));
  const QUrlQuery query(url);
  const QString socket = query.queryItemValue(QStringLiteral("host"), QUrl::FullyDecoded);
  const QString port = query.queryItemValue(QStringLiteral("port"));
  db.setHostName(socket.isEmpty() ? url.host() : socket);
  db.setUserName(url.userName());
  db.setPassword(url.password());
  db.setDatabaseName(url.path().mid(1));
  if (url.port() > 0) db.setPort(url.port());
  if (!port.isEmpty()) db.setPort(port.toInt());
  db.setConnectOptions(QStringLiteral("connect_timeout=5"));
}

// whether the file of an SQLite store can be written or read; it is made when it is to be written
bool file_ready(const std::string& where, Access access, std::string& error) {
  if (access == Access::kWrite) return make_private_file(where, error);
  if (::access(where.c_str(), R_OK) == 0) return true;
  error = where + " cannot be read: " + std::strerror(errno) + ".";
  return false;
}

void configure_sqlite(QSqlDatabase& db, const std::string& where, Access access) {
  db.setDatabaseName(QString::fromStdString(where));
  // 2000 ms: longer than any measured commit, shorter than the recorder's ring lasts
  db.setConnectOptions(access == Access::kRead
                           ? QStringLiteral("QSQLITE_BUSY_TIMEOUT=2000;QSQLITE_OPEN_READONLY")
                           : QStringLiteral("QSQLITE_BUSY_TIMEOUT=2000"));
}

}  // namespace

int64_t integer(const Value& value) {
  if (const auto* v = std::get_if<int64_t>(&value)) return *v;
  const auto* v = std::get_if<double>(&value);
  return v != nullptr && std::abs(*v) < 9e18 ? static_cast<int64_t>(*v) : 0;
}

double real(const Value& value) {
  if (const auto* v = std::get_if<double>(&value)) return *v;
  const auto* v = std::get_if<int64_t>(&value);
  return v != nullptr ? static_cast<double>(*v) : std::numeric_limits<double>::quiet_NaN();
}

std::string text(const Value& value) {
  const auto* v = std::get_if<std::string>(&value);
  return v != nullptr ? *v : std::string();
}

const Blob& blob(const Value& value) {
  static const Blob kEmpty;
  const auto* v = std::get_if<Blob>(&value);
  return v != nullptr ? *v : kEmpty;
}

bool is_postgres(std::string_view where) {
  return where.starts_with("postgresql://") || where.starts_with("postgres://");
}

struct Database::Connection {
  QString name;
  QSqlDatabase db;
  bool postgres = false;
  std::map<std::string, QSqlQuery, std::less<>> prepared;
  QSqlQuery plain;
  Trouble trouble = Trouble::kNone;
  std::string error;

  bool ok() {
    trouble = Trouble::kNone;
    error.clear();
    return true;
  }
  bool failed(const QSqlError& what) {
    trouble = classify(what, postgres);
    if (trouble == Trouble::kNone) trouble = Trouble::kOther;
    error = what.text().simplified().toStdString();
    return false;
  }

  // nullptr on failure
  QSqlQuery* execute(std::string_view sql, const Row& values) {
    return values.empty() ? execute_plain(sql) : execute_prepared(sql, values);
  }

  // PostgreSQL prepares neither transactions nor changes of tables
  QSqlQuery* execute_plain(std::string_view sql) {
    plain = QSqlQuery(db);
    plain.setForwardOnly(true);
    if (plain.exec(QString::fromUtf8(sql.data(), static_cast<qsizetype>(sql.size())))) {
      ok();
      return &plain;
    }
    failed(plain.lastError());
    plain.finish();
    return nullptr;
  }

  // compiled once per connection, executed with these values
  QSqlQuery* execute_prepared(std::string_view sql, const Row& values) {
    auto found = prepared.find(sql);
    if (found == prepared.end()) {
      QSqlQuery query(db);
      query.setForwardOnly(true);
      if (!query.prepare(QString::fromUtf8(sql.data(), static_cast<qsizetype>(sql.size())))) {
        failed(query.lastError());
        return nullptr;
      }
      found = prepared.emplace(std::string(sql), std::move(query)).first;
    }
    QSqlQuery& query = found->second;
    for (std::size_t i = 0; i < values.size(); ++i) query.bindValue(static_cast<int>(i), to_qt(values[i]));
    if (query.exec()) {
      ok();
      return &query;
    }
    failed(query.lastError());
    query.finish();
    return nullptr;
  }
};

Database::Database(std::unique_ptr<Connection> connection) : connection_(std::move(connection)) {}

Database::~Database() {
  connection_->prepared.clear();
  connection_->plain = QSqlQuery();
  connection_->db.close();
  connection_->db = QSqlDatabase();
  QSqlDatabase::removeDatabase(connection_->name);
}

std::unique_ptr<Database> Database::open(const std::string& where, Access access, std::string& error,
                                         Trouble* why) {
  const bool postgres = is_postgres(where);
  if (why != nullptr) *why = Trouble::kOther;
  if (!postgres && !file_ready(where, access, error)) {
    if (why != nullptr && errno == ENOSPC) *why = Trouble::kFull;
    return nullptr;
  }

  const QString driver = postgres ? QStringLiteral("QPSQL") : QStringLiteral("QSQLITE");
  if (!QSqlDatabase::isDriverAvailable(driver)) {
    error = "Qt's SQL driver " + driver.toStdString() + " is not installed: install the package " +
            (postgres ? "libqt6sql6-psql." : "libqt6sql6-sqlite.");
    return nullptr;
  }
  auto connection = std::make_unique<Connection>();
  connection->postgres = postgres;
  connection->name = unique_name();
  connection->db = QSqlDatabase::addDatabase(driver, connection->name);
  if (postgres)
    configure_postgres(connection->db, where);
  else
    configure_sqlite(connection->db, where, access);
  const bool opened = connection->db.open();
  if (!opened) {
    connection->failed(connection->db.lastError());
    error = where + " cannot be opened: " + connection->error + ".";
  }
  std::unique_ptr<Database> database(new Database(std::move(connection)));
  if (why != nullptr) *why = database->trouble();
  if (!opened) return nullptr;
  if (!postgres) {
    database->run("PRAGMA foreign_keys = ON");
    database->run("PRAGMA trusted_schema = OFF");
    if (access == Access::kWrite) database->run("PRAGMA secure_delete = ON");
  }
  return database;
}

bool Database::run(std::string_view sql, const Row& values) {
  QSqlQuery* query = connection_->execute(sql, values);
  if (query == nullptr) return false;
  query->finish();
  return true;
}

bool Database::each(std::string_view sql, const Row& values, const std::function<bool(const Row&)>& visit) {
  QSqlQuery* query = connection_->execute(sql, values);
  if (query == nullptr) return false;
  const int columns = query->record().count();
  Row row(static_cast<std::size_t>(columns));
  while (query->next()) {
    for (int i = 0; i < columns; ++i) row[static_cast<std::size_t>(i)] = from_qt(query->value(i));
    if (!visit(row)) break;
  }
  const QSqlError end = query->lastError();
  query->finish();
  return end.type() == QSqlError::NoError ? true : connection_->failed(end);
}

std::vector<Row> Database::rows(std::string_view sql, const Row& values) {
  std::vector<Row> out;
  if (!each(sql, values, [&](const Row& row) {
        out.push_back(row);
        return true;
      }))
    out.clear();
  return out;
}

bool Database::begin() { return run(connection_->postgres ? "BEGIN" : "BEGIN IMMEDIATE"); }
bool Database::commit() { return run("COMMIT"); }

void Database::rollback() {
  // the reason that made the caller roll back is worth more than the answer to this
  const Trouble trouble = connection_->trouble;
  const std::string error = connection_->error;
  run("ROLLBACK");
  connection_->trouble = trouble;
  connection_->error = error;
}

bool Database::on_postgres() const { return connection_->postgres; }
Trouble Database::trouble() const { return connection_->trouble; }
const std::string& Database::error() const { return connection_->error; }

}  // namespace swage::record

// SPDX-License-Identifier: Apache-2.0
#include "record/sql.hpp"

#include <QtCore/QByteArray>
#include <QtCore/QMetaType>
#include <QtCore/QVariant>
#include <QtSql/QSqlDatabase>
#include <QtSql/QSqlDriver>
#include <QtSql/QSqlError>
#include <QtSql/QSqlQuery>
#include <QtSql/QSqlRecord>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "record/patience.hpp"
#include "record/sentences.hpp"
#include "record/sql_connect.hpp"

namespace swage::record {
namespace {

// 3 s: the step's ring holds 4 s, so that a server that stops responding loses no step; a query takes milliseconds.
// A smaller limit fails on a slow network, a larger one loses steps.
constexpr std::chrono::milliseconds kAnswer{3000};

QVariant to_qt(const Value& value) {
  struct Visit {
    QVariant operator()(std::monostate) const { return QVariant(QMetaType(QMetaType::QString)); }
    QVariant operator()(int64_t v) const { return QVariant(static_cast<qlonglong>(v)); }
    QVariant operator()(double v) const {
      return std::isnan(v) ? QVariant(QMetaType(QMetaType::Double)) : QVariant(v);
    }
    QVariant operator()(const std::string& v) const { return QVariant(QString::fromStdString(v)); }
    QVariant operator()(const Blob& v) const {
      // a null pointer would give NULL, which differs from an empty blob
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

// PostgreSQL's codes have five characters: class 53 is lack of resources, 08 and 57P a lost connection; without a code the server
// was never reached
Trouble classify_postgres(const QString& code) {
  if (code.startsWith(QLatin1String("53"))) return Trouble::kFull;
  if (code == QLatin1String("25006") || code == QLatin1String("42501")) return Trouble::kReadOnly;
  if (code.isEmpty() || code.startsWith(QLatin1String("08")) || code.startsWith(QLatin1String("57P")))
    return Trouble::kUnreachable;
  if (code.startsWith(QLatin1String("XX"))) return Trouble::kDamaged;
  // lock timeout; a deadlock that the server has resolved
  const bool locked = code == QLatin1String("55P03") || code == QLatin1String("40P01");
  return locked ? Trouble::kLocked : Trouble::kOther;
}

// the low byte of SQLite's extended result codes
Trouble classify_sqlite(int code) {
  switch (code & 0xff) {
    case 5:  // SQLITE_BUSY
    case 6:  // SQLITE_LOCKED
      return Trouble::kLocked;
    case 8:   // SQLITE_READONLY
    case 14:  // SQLITE_CANTOPEN: its log or shared memory cannot be created beside it
      return Trouble::kReadOnly;
    case 10:  // SQLITE_IOERR: also for a file above the size limit of the system
    case 13:  // SQLITE_FULL
      return Trouble::kFull;
    case 11:  // SQLITE_CORRUPT
    case 26:  // SQLITE_NOTADB
      return Trouble::kDamaged;
    default:
      return Trouble::kOther;
  }
}

Trouble classify(const QSqlError& error, bool postgres) {
  if (error.type() == QSqlError::NoError) return Trouble::kNone;
  return postgres ? classify_postgres(error.nativeErrorCode())
                  : classify_sqlite(error.nativeErrorCode().toInt());
}

QString unique_name() {
  static std::atomic<uint64_t> count{0};
  return QStringLiteral("swage_record_%1").arg(++count);
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

struct Database::Connection {
  QString name;
  std::string where;
  QSqlDatabase db;
  bool postgres = false;
  std::optional<Patience> patience;  // PostgreSQL only
  std::map<std::string, QSqlQuery, std::less<>> prepared;
  QSqlQuery plain;
  std::map<QString, std::function<void()>> listeners;  // by channel
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
    error = without_password(what.text().simplified().toStdString(), where);
    if (patience && patience->at_an_end()) {
      trouble = Trouble::kUnreachable;
      error = say::kServerSilent();
    }
    return false;
  }
  // a call to the server, with the timeout
  template <class Call>
  bool ask(const Call& call) {
    if (patience) patience->begin();
    const bool good = call();
    if (patience) patience->end();
    return good;
  }

  // nullptr on failure
  QSqlQuery* execute(std::string_view sql, const Row& values) {
    return values.empty() ? execute_plain(sql) : execute_prepared(sql, values);
  }

  // PostgreSQL cannot prepare transactions and changes of tables
  QSqlQuery* execute_plain(std::string_view sql) {
    plain = QSqlQuery(db);
    plain.setForwardOnly(true);
    if (ask([&] { return plain.exec(QString::fromUtf8(sql.data(), static_cast<qsizetype>(sql.size()))); })) {
      ok();
      return &plain;
    }
    failed(plain.lastError());
    plain.finish();
    return nullptr;
  }

  // compiled once per connection, then executed with these values
  QSqlQuery* execute_prepared(std::string_view sql, const Row& values) {
    auto found = prepared.find(sql);
    if (found == prepared.end()) {
      QSqlQuery query(db);
      query.setForwardOnly(true);
      if (!ask([&] { return query.prepare(QString::fromUtf8(sql.data(), static_cast<qsizetype>(sql.size()))); })) {
        failed(query.lastError());
        return nullptr;
      }
      found = prepared.emplace(std::string(sql), std::move(query)).first;
    }
    QSqlQuery& query = found->second;
    for (std::size_t i = 0; i < values.size(); ++i) query.bindValue(static_cast<int>(i), to_qt(values[i]));
    if (ask([&] { return query.exec(); })) {
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
  if (connection_->patience) connection_->patience->begin();
  connection_->prepared.clear();
  connection_->plain = QSqlQuery();
  connection_->db.close();
  connection_->db = QSqlDatabase();
  QSqlDatabase::removeDatabase(connection_->name);
}

std::unique_ptr<Database> Database::open(const std::string& where, Access access, std::string& error,
                                         Trouble* why) {
  Trouble ignored;
  Trouble& trouble = why != nullptr ? *why : ignored;
  trouble = Trouble::kOther;
  const bool postgres = is_postgres(where);
  error = address_problem(where);
  const bool in_file = !postgres && where != kInMemory;
  if (!error.empty() || (in_file && !file_ready(where, access, error, trouble))) return nullptr;

  const QString driver = postgres ? QStringLiteral("QPSQL") : QStringLiteral("QSQLITE");
  if (!QSqlDatabase::isDriverAvailable(driver)) {
    error = "Qt's SQL driver " + driver.toStdString() + " is not installed: install the package " +
            (postgres ? "libqt6sql6-psql." : "libqt6sql6-sqlite.");
    return nullptr;
  }
  auto connection = std::make_unique<Connection>();
  connection->where = where;
  connection->postgres = postgres;
  connection->name = unique_name();
  connection->db = QSqlDatabase::addDatabase(driver, connection->name);
  std::unique_ptr<Database> database(new Database(std::move(connection)));
  if (!database->connect(access, error)) {
    trouble = database->trouble();
    return nullptr;
  }
  trouble = Trouble::kNone;
  return database;
}

bool Database::connect(Access access, std::string& error) {
  Connection& c = *connection_;
  if (!c.postgres)
    configure_sqlite(c.db, c.where, access);
  else if (!configure_postgres(c.db, c.where, error))
    return false;
  if (!c.db.open()) {
    c.failed(c.db.lastError());
    error = say::kNotOpened(shown(c.where), c.error);
    return false;
  }
  if (c.postgres) {
    c.patience.emplace(socket_of(c.db), kAnswer);
    // timeout for another station's lock, as with SQLite
    run("SET lock_timeout = '2s'");
    // every statement here takes milliseconds; without statistics the server expects some to be long and compiles them first,
    // which costs 250 ms
    run("SET jit = off");
    run("SET client_min_messages = warning");  // suppresses notices such as "already exists, skipping"
    return true;
  }
  run("PRAGMA foreign_keys = ON");
  run("PRAGMA trusted_schema = OFF");
  if (access == Access::kWrite) run("PRAGMA secure_delete = ON");
  return true;
}

bool Database::run(std::string_view sql, const Row& values) {
  QSqlQuery* query = connection_->execute(sql, values);
  if (query == nullptr) return false;
  // reads all rows: behind unread rows libpq holds back the server's notifications until the next call
  while (query->next()) continue;
  query->finish();
  return true;
}

bool Database::each(std::string_view sql, const Row& values, const std::function<bool(const Row&)>& visit) {
  QSqlQuery* query = connection_->execute(sql, values);
  if (query == nullptr) return false;
  const int columns = query->record().count();
  Row row(static_cast<std::size_t>(columns));
  while (connection_->ask([&] { return query->next(); })) {
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
  // keeps the error that made the caller roll back, not the result of this statement
  const Trouble trouble = connection_->trouble;
  const std::string error = connection_->error;
  run("ROLLBACK");
  connection_->trouble = trouble;
  connection_->error = error;
}

bool Database::listen(const std::string& channel, std::function<void()> heard) {
  Connection& c = *connection_;
  QSqlDriver* driver = c.db.driver();
  if (!c.postgres || !driver->hasFeature(QSqlDriver::EventNotifications)) return false;
  if (c.listeners.empty())
    QObject::connect(driver, &QSqlDriver::notification, driver, [&c](const QString& name) {
      if (const auto found = c.listeners.find(name); found != c.listeners.end()) found->second();
    });
  const QString name = QString::fromStdString(channel);
  const bool good = c.ask([&] { return driver->subscribeToNotification(name); });
  if (!good) return c.failed(driver->lastError());
  c.listeners[name] = std::move(heard);
  return c.ok();
}

bool Database::on_postgres() const { return connection_->postgres; }
Trouble Database::trouble() const { return connection_->trouble; }
const std::string& Database::error() const { return connection_->error; }

}  // namespace swage::record

// SPDX-License-Identifier: Apache-2.0
//
// Set-up of a connection, for sql.cpp alone: rights, read-only folders, addresses of servers.
#pragma once

#include <string>

#include "record/sql.hpp"

class QSqlDatabase;

namespace swage::record {

/// Creates the file of a store to be written. False with a sentence for a path that is no regular file or may not be used.
bool file_ready(const std::string& where, Access, std::string& error, Trouble& why);
void configure_sqlite(QSqlDatabase&, const std::string& where, Access);

/// False with a sentence when the address has a part that Swage does not know.
bool configure_postgres(QSqlDatabase&, const std::string& where, std::string& error);
/// The socket of an open connection to a server, -1 when unknown.
int socket_of(const QSqlDatabase&);

}  // namespace swage::record

#pragma once

#include <SQLiteCpp/Database.h>

#include <span>

namespace cell::library {

/// Step i brings a database from schema i to i + 1; what was stored under an
/// older one stays. Steps are only ever added.
std::span<const char* const> LibrarySchema();

/// 0 of an empty database. @throws std::invalid_argument with what is wrong and
/// what to do, for another program's database and for a schema that is newer
/// than `newest`; SQLite::Exception.
int SchemaVersion(const SQLite::Database& database, int newest);

/// Brings `database` to the newest schema, all in one transaction. @throws like
/// SchemaVersion().
void Migrate(SQLite::Database& database, std::span<const char* const> steps);

}  // namespace cell::library

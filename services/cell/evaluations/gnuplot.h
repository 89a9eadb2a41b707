#pragma once

#include <string>

namespace cell::cli {

/// Lets gnuplot run `program`. Returns what is wrong, or nothing: that gnuplot
/// is not installed is no failure of an evaluation whose numbers are written.
std::string RunGnuplot(const std::string& program);

/// Where WritePlottedTable() draws the table of a file.
std::string PictureOf(const std::string& csv_file);
/// Writes a new table and lets `program` draw its picture. Returns what was
/// written, in lines for people. @throws as WriteNewFile()
std::string WritePlottedTable(const std::string& csv_file,
                              const std::string& csv,
                              const std::string& program, const char* advice);

}  // namespace cell::cli

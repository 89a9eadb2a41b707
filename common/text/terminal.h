#pragma once

namespace cell {

/// True if control codes may be written to the file descriptor: it is a
/// terminal, one that knows them (TERM is set and not "dumb"), and the person
/// has not refused them (NO_COLOR is unset or empty).
bool TakesTerminalCodes(int descriptor);

/// Columns of the user's screen: COLUMNS, else those of the terminal, else 80.
int TerminalColumns(int descriptor);

}  // namespace cell

#pragma once

namespace cell {

/// True if control codes may be written to the file descriptor: it is a
/// terminal, one that knows them (TERM is set and not "dumb"), and the person
/// does not mind (NO_COLOR is unset or empty).
bool TakesTerminalCodes(int descriptor);

/// Columns of the person's screen: COLUMNS, else what the terminal says, else
/// 80.
int TerminalColumns(int descriptor);

}  // namespace cell

#pragma once

#include "common/sec/entry_counts.h"
#include "common/sec/relation_matrix.h"

namespace cell {

/// Which rows and which columns of two matrices correspond: each at most once,
/// columns in their order.
struct ChainAlignment {
  LinePairs rows;
  LinePairs columns;
  int num_equal = 0;  ///< entries where both correspond
};

enum class RowRoles : int8_t {
  kIgnored,
  kKept  ///< only rows of one role correspond
};

/// Aligns rows and columns in turn so that as many entries as possible are
/// equal. With rows that correspond for a start,
///
///   columns = argmax over monotone C of   sum_{(u,v) in C} N_rows(u, v)
///   rows    = argmax over one-to-one R of sum_{(i,j) in R} N_columns(i, j)
///
/// alternate, N_rows(u, v) being the number of equal entries of columns u and v
/// in corresponding rows, and N_columns(i, j) that of rows i and j in
/// corresponding columns. Neither step makes the number of equal entries
/// smaller; the end is a local maximum. Of two starts the better end counts:
/// rows that correspond by their longest common subsequences, and rows that
/// agree best in columns at about the same place of both chains.
ChainAlignment AlignChains(const RelationMatrix& a, const RelationMatrix& b,
                           RowRoles roles);

/// The Dice coefficient: twice the equal entries, divided by all of both.
double DiceOf(const ChainAlignment& alignment, const RelationMatrix& a,
              const RelationMatrix& b);

/// Of row i of `a` and j of `b` at i * b.num_rows() + j: the length of their
/// longest common subsequence.
std::vector<int> CommonLengths(const RelationMatrix& a,
                               const RelationMatrix& b);

}  // namespace cell

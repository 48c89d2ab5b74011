// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_block_smoother_h
#define mortar_contact_structure_block_smoother_h

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_Vector.h>

#include <array>
#include <memory>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /**
   * Gauss-Seidel's method on a copy of a matrix in single precision, in blocks
   * of 3 x 3 (two nodes of a solid): sweeps read a third of what they would
   * read of the original.
   *
   * Rows are taken in threes as they are numbered. Any matrix will do, but only
   * where nodes have three or six unknowns are the blocks full. Unknowns of
   * other ranks wait until the end of a sweep; half of the sums of what couples
   * to them are added to the diagonal, which makes the sweeps converge for any
   * definite matrix and any partition (A. Baker et al., Multigrid smoothers for
   * ultraparallel computing, doi:10.1137/100798806).
   */
  class BlockSmoother
  {
  public:
    static constexpr unsigned int size = 3; ///< Of a block.

    using Values = std::vector<float>;             ///< Of a vector.
    using Block  = std::array<float, size * size>; ///< By columns.

    /// The pattern, not the values, of a matrix that outlives this.
    explicit BlockSmoother(const TrilinosWrappers::SparseMatrix &matrix);

    void
    copy_values();

    /// Length of vectors: unknowns of this rank, what fills up the last block,
    /// and those of other ranks that a product needs.
    unsigned int
    n_columns() const
    {
      return size * n_block_columns;
    }

    /// Forward sweep from zero: @p x; the residual takes the place of @p r.
    void
    forward_from_zero(Values &x, Values &r) const;

    /// Backward sweep from @p x for the right-hand side @p b.
    void
    backward(Values &x, const Values &b) const;

  private:
    /// Get the values of other ranks.
    void
    exchange(Values &x) const;

    /// Three values; the fourth is of no account. One instruction then serves a
    /// column of a block.
    using Four = float __attribute__((vector_size(4 * sizeof(float))));

    static Four
    column(const Block &block, const unsigned int j);

    static Four
    product(const Block &block, const float *x);

    /// @p s without what blocks from @p block on contribute, up to the column
    /// before @p end.
    static Four
    subtract(const Block        *block,
             const unsigned int *column,
             const unsigned int *end,
             const Values       &x,
             Four                s);

    const Epetra_CrsMatrix &original;

    /// Where the value of a local column of the original is in vectors.
    std::vector<unsigned int> position;

    unsigned int              n_block_rows = 0, n_block_columns = 0;
    std::vector<std::size_t>  row_begin; ///< By block row.
    std::vector<std::size_t>  diagonal;  ///< Its block, by block row.
    std::vector<unsigned int> columns;   ///< Of blocks.
    /// One more than there are: see column().
    std::vector<Block>             blocks, inverse_diagonal;
    std::unique_ptr<Epetra_Vector> owned, ghosted; ///< To exchange values.
  };
} // namespace Structure

#endif

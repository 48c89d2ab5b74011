// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_local_rows_h
#define mortar_contact_host_local_rows_h

#include <deal.II/base/types.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <utility>
#include <vector>

namespace MortarContact
{
  using namespace dealii;

  /**
   * Adds dense blocks to a Trilinos matrix: to the rows that this rank owns by
   * their local numbers, which are looked up once for all dofs that blocks may
   * have, not for each entry of each block.
   */
  class LocalRows
  {
  public:
    /// @param dofs All dofs that blocks may have, sorted.
    LocalRows(TrilinosWrappers::SparseMatrix             &matrix,
              const std::vector<types::global_dof_index> &dofs,
              const AffineConstraints<double>            &constraints);

    /**
     * matrix += @p block, of the dofs @p block_dofs, each of them once.
     * @return False, and nothing is done, if a dof is constrained.
     * @throw ExcMessage if the matrix has no such entry.
     */
    bool
    add(const FullMatrix<double>                   &block,
        const std::vector<types::global_dof_index> &block_dofs);

  private:
    TrilinosWrappers::SparseMatrix             &matrix;
    const std::vector<types::global_dof_index> &dofs;
    static constexpr int is_constrained = -2, of_another_rank = -1;
    std::vector<int>     rows;    ///< By dof.
    std::vector<int>     columns; ///< By dof.
    /// Column and place in the block, of one block.
    std::vector<std::pair<int, unsigned int>> order;
    std::vector<int>                          block_rows;
  };
} // namespace MortarContact

#endif

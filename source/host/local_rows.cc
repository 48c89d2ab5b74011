// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/local_rows.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <algorithm>
#include <string>

namespace MortarContact
{
  LocalRows::LocalRows(TrilinosWrappers::SparseMatrix             &matrix,
                       const std::vector<types::global_dof_index> &dofs,
                       const AffineConstraints<double>            &constraints)
    : matrix(matrix)
    , dofs(dofs)
  {
    const Epetra_CrsMatrix &epetra = matrix.trilinos_matrix();
    rows.reserve(dofs.size());
    columns.reserve(dofs.size());
    for (const auto dof : dofs)
      {
        const auto number = static_cast<TrilinosWrappers::types::int_type>(dof);
        rows.push_back(constraints.is_constrained(dof) ?
                         is_constrained :
                         epetra.RowMap().LID(number));
        columns.push_back(epetra.ColMap().LID(number));
      }
  }


  bool
  LocalRows::add(const FullMatrix<double>                   &block,
                 const std::vector<types::global_dof_index> &block_dofs)
  {
    order.clear();
    block_rows.clear();
    for (unsigned int k = 0; k < block_dofs.size(); ++k)
      {
        const std::size_t place =
          std::lower_bound(dofs.begin(), dofs.end(), block_dofs[k]) -
          dofs.begin();
        if (rows[place] == is_constrained)
          return false;
        block_rows.push_back(rows[place]);
        order.emplace_back(columns[place], k);
      }
    std::sort(order.begin(), order.end());
    for (unsigned int k = 0; k < block_dofs.size(); ++k)
      {
        if (block_rows[k] == of_another_rank)
          {
            matrix.add(block_dofs[k],
                       block_dofs.size(),
                       block_dofs.data(),
                       &block(k, 0));
            continue;
          }
        int     n;
        double *values;
        int    *row;
        matrix.trilinos_matrix().ExtractMyRowView(block_rows[k],
                                                  n,
                                                  values,
                                                  row);
        const int *const end = row + n;
        const int       *at  = row;
        for (const auto &[column, l] : order)
          {
            // the components of a node are next to each other
            if (at == end || *at != column)
              at = std::lower_bound(at, static_cast<const int *>(end), column);
            AssertThrow(at != end && *at == column,
                        ExcMessage("The matrix has no entry for contact at (" +
                                   std::to_string(block_dofs[k]) + ", " +
                                   std::to_string(block_dofs[l]) +
                                   "); its pattern must be that of "
                                   "add_couplings()."));
            values[at - row] += block(k, l);
            ++at;
          }
      }
    return true;
  }
} // namespace MortarContact

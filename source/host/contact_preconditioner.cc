// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/contact_preconditioner.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <Amesos.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_Vector.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace MortarContact
{
  void
  ContactBlock::initialize(const TrilinosWrappers::SparseMatrix &matrix,
                           const IndexSet                       &dofs)
  {
    const MPI_Comm communicator = matrix.get_mpi_communicator();
    Assert((dofs & matrix.locally_owned_range_indices()) == dofs,
           ExcMessage("The dofs are not those of this rank."));
    factors.reset();
    dofs.fill_index_vector(own_dofs);

    // Step 1: numbers in the block, also of the columns of other ranks.
    const auto counts =
      Utilities::MPI::all_gather(communicator,
                                 static_cast<unsigned int>(own_dofs.size()));
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int first =
      std::accumulate(counts.begin(), counts.begin() + rank, 0u);
    const unsigned int total =
      std::accumulate(counts.begin(), counts.end(), 0u);
    IndexSet owned(total);
    owned.add_range(first, first + own_dofs.size());
    if (total == 0)
      {
        block.clear();
        return;
      }
    const Epetra_CrsMatrix &A = matrix.trilinos_matrix();
    Epetra_Vector           of_rows(A.RowMap()), of_columns(A.ColMap());
    of_rows.PutScalar(-1.);
    for (unsigned int i = 0; i < own_dofs.size(); ++i)
      of_rows[A.RowMap().LID(static_cast<int>(own_dofs[i]))] = first + i;
    if (A.Importer() != nullptr)
      of_columns.Import(of_rows, *A.Importer(), Insert);
    else
      for (int i = 0; i < of_columns.MyLength(); ++i)
        of_columns[i] = of_rows[i];

    // Step 2: the block.
    DynamicSparsityPattern               pattern(total, total, owned);
    std::vector<types::global_dof_index> columns;
    std::vector<TrilinosScalar>          values;
    const auto                           row = [&](const unsigned int i) {
      int     n = 0, *local = nullptr;
      double *of = nullptr;
      A.ExtractMyRowView(A.RowMap().LID(static_cast<int>(own_dofs[i])),
                         n,
                         of,
                         local);
      columns.clear();
      values.clear();
      for (int k = 0; k < n; ++k)
        if (of_columns[local[k]] >= 0.)
          {
            columns.push_back(std::lround(of_columns[local[k]]));
            values.push_back(of[k]);
          }
    };
    for (unsigned int i = 0; i < own_dofs.size(); ++i)
      {
        row(i);
        pattern.add_entries(first + i, columns.begin(), columns.end());
      }
    block.clear();
    block.reinit(owned, owned, pattern, communicator);
    for (unsigned int i = 0; i < own_dofs.size(); ++i)
      {
        row(i);
        block.set(first + i, columns, values);
      }
    block.compress(VectorOperation::insert);

    // Step 3: its factors.
    const std::string method =
      Amesos().Query("Amesos_Mumps") ? "Amesos_Mumps" : "Amesos_Klu";
    factors = std::make_unique<TrilinosWrappers::SolverDirect>(
      control, TrilinosWrappers::SolverDirect::AdditionalData(false, method));
    factors->initialize(block);
    right.reinit(owned, communicator);
    solution.reinit(owned, communicator);
  }


  void
  ContactBlock::vmult_add(TrilinosWrappers::MPI::Vector       &dst,
                          const TrilinosWrappers::MPI::Vector &src) const
  {
    if (n_dofs() == 0)
      return;
    const auto first = src.local_range().first;
    for (unsigned int i = 0; i < own_dofs.size(); ++i)
      right.begin()[i] = src.begin()[own_dofs[i] - first];
    factors->solve(solution, right);
    for (unsigned int i = 0; i < own_dofs.size(); ++i)
      dst.begin()[own_dofs[i] - first] += solution.begin()[i];
  }
} // namespace MortarContact

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "direct_solver.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <dmumps_c.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <vector>

namespace Structure
{
  namespace
  {
    // jobs, control parameters and errors by their numbers in MUMPS' manual
    enum Job
    {
      start     = -1,
      end       = -2,
      analyse   = 1,
      factorise = 2,
      backsolve = 3
    };
    constexpr int distributed_matrix    = 3;
    constexpr int workspace_too_small[] = {-8, -9, -11, -14, -15, -17, -20};

    /// Workspace beyond what the analysis foresees [percent]: at the start, and
    /// the factor after it did not suffice.
    constexpr int more_workspace = 30, growth_of_workspace = 3,
                  most_workspace = 1000;
  } // namespace


  struct DirectSolver::Data
  {
    MPI_Comm            communicator;
    DMUMPS_STRUC_C      mumps   = {};
    bool                is_used = false;
    unsigned int        pattern = numbers::invalid_unsigned_int;
    std::vector<int>    rows, columns; ///< Of this rank's entries, from 1.
    std::vector<double> entries, all;  ///< All values of a vector, on rank 0.
    std::vector<int>    counts, firsts;

    /// Run a job on all ranks. @return MUMPS' error, the same everywhere.
    int
    run(const Job job)
    {
      mumps.job = job;
      dmumps_c(&mumps);
      return mumps.infog[0];
    }

    /// Solve with the factors of the matrix.
    int
    backsolve_with(const TrilinosWrappers::MPI::Vector &rhs,
                   TrilinosWrappers::MPI::Vector       &x)
    {
      const int n = counts[Utilities::MPI::this_mpi_process(communicator)];
      MPI_Gatherv(rhs.begin(),
                  n,
                  MPI_DOUBLE,
                  all.data(),
                  counts.data(),
                  firsts.data(),
                  MPI_DOUBLE,
                  0,
                  communicator);
      const int error = run(backsolve);
      MPI_Scatterv(all.data(),
                   counts.data(),
                   firsts.data(),
                   MPI_DOUBLE,
                   x.begin(),
                   n,
                   MPI_DOUBLE,
                   0,
                   communicator);
      return error;
    }

    int &
    control(const unsigned int i)
    {
      return mumps.icntl[i - 1];
    }

    void
    stop()
    {
      if (is_used)
        run(end);
      is_used = false;
    }

    void
    begin(const Epetra_CrsMatrix &matrix)
    {
      stop();
      mumps              = {};
      mumps.par          = 1;
      mumps.sym          = 0;
      mumps.comm_fortran = MPI_Comm_c2f(communicator);
      run(start);
      is_used = true;
      for (unsigned int i = 1; i <= 4; ++i)
        control(i) = (i == 4) ? 0 : -1; // silent
      control(14) = more_workspace;
      control(18) = distributed_matrix;

      rows.clear();
      columns.clear();
      for (int i = 0; i < matrix.NumMyRows(); ++i)
        {
          int     n;
          double *values;
          int    *locals;
          matrix.ExtractMyRowView(i, n, values, locals);
          for (int k = 0; k < n; ++k)
            {
              rows.push_back(matrix.GRID(i) + 1);
              columns.push_back(matrix.GCID(locals[k]) + 1);
            }
        }
      entries.resize(rows.size());
      mumps.n       = matrix.NumGlobalRows();
      mumps.nnz_loc = rows.size();
      mumps.irn_loc = rows.data();
      mumps.jcn_loc = columns.data();
      mumps.a_loc   = entries.data();

      // ranks own contiguous rows, one after the other
      const int n_rows = matrix.NumMyRows();
      counts           = Utilities::MPI::all_gather(communicator, n_rows);
      firsts.assign(counts.size(), 0);
      for (std::size_t r = 1; r < counts.size(); ++r)
        firsts[r] = firsts[r - 1] + counts[r - 1];
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        {
          all.resize(mumps.n);
          mumps.rhs = all.data();
        }
    }
  };


  DirectSolver::DirectSolver(const MPI_Comm communicator)
    : data(std::make_unique<Data>())
  {
    data->communicator = communicator;
  }


  DirectSolver::~DirectSolver()
  {
    // the end is collective; where an exception unwinds, other ranks may be
    // elsewhere
    if (std::uncaught_exceptions() == 0)
      data->stop();
  }


  bool
  DirectSolver::factorise(const TrilinosWrappers::SparseMatrix &matrix,
                          const unsigned int                    pattern)
  {
    Data                   &d     = *data;
    const Epetra_CrsMatrix &A     = matrix.trilinos_matrix();
    int                     error = 0;
    if (d.pattern != pattern)
      {
        d.pattern = numbers::invalid_unsigned_int;
        d.begin(A);
      }
    std::size_t position = 0;
    for (int i = 0; i < A.NumMyRows(); ++i)
      {
        int     n;
        double *values;
        int    *locals;
        A.ExtractMyRowView(i, n, values, locals);
        std::copy(values, values + n, d.entries.begin() + position);
        position += n;
      }
    if (d.pattern != pattern)
      error = d.run(analyse);
    while (error >= 0)
      {
        error               = d.run(Job::factorise);
        const bool is_small = std::find(std::begin(workspace_too_small),
                                        std::end(workspace_too_small),
                                        error) != std::end(workspace_too_small);
        if (!is_small || d.control(14) >= most_workspace)
          break;
        d.control(14) *= growth_of_workspace;
        error = 0;
      }
    if (error >= 0)
      d.pattern = pattern;
    const int singular_matrix[] = {-6, -10};
    AssertThrow(error >= 0 || std::find(std::begin(singular_matrix),
                                        std::end(singular_matrix),
                                        error) != std::end(singular_matrix),
                ExcMessage("The direct solver (MUMPS) failed with error " +
                           std::to_string(error) + ", " +
                           std::to_string(d.mumps.infog[1]) +
                           (error == -13 || error == -9 ?
                              ": memory does not suffice; expected a smaller "
                              "mesh or 'Solver/Linear/Type = iterative'." :
                              ", see its manual.")));
    return error >= 0;
  }


  void
  DirectSolver::vmult(TrilinosWrappers::MPI::Vector       &x,
                      const TrilinosWrappers::MPI::Vector &rhs) const
  {
    const int error = data->backsolve_with(rhs, x);
    AssertThrow(error >= 0,
                ExcMessage("The direct solver (MUMPS) failed with error " +
                           std::to_string(error) + ", see its manual."));
  }
} // namespace Structure

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_contact_preconditioner_h
#define mortar_contact_host_contact_preconditioner_h

#include <deal.II/base/index_set.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>
#include <vector>

namespace MortarContact
{
  using namespace dealii;

  /// The exact solution of a matrix restricted to some of its dofs.
  class ContactBlock
  {
  public:
    /**
     * Take the block out of @p matrix and factorise it. Collective.
     * @param dofs Of the dofs that this rank owns, see
     *             ContactInterface::active_dofs().
     * @throw ExceptionBase of deal.II if the block is singular.
     */
    void
    initialize(const TrilinosWrappers::SparseMatrix &matrix,
               const IndexSet                       &dofs);

    /// Of all ranks.
    types::global_dof_index
    n_dofs() const
    {
      return block.m();
    }

    /// Add the solution for the right-hand side @p src to @p dst.
    void
    vmult_add(TrilinosWrappers::MPI::Vector       &dst,
              const TrilinosWrappers::MPI::Vector &src) const;

  private:
    std::vector<types::global_dof_index>                    own_dofs;
    TrilinosWrappers::SparseMatrix                          block;
    mutable SolverControl                                   control;
    mutable std::unique_ptr<TrilinosWrappers::SolverDirect> factors;
    mutable TrilinosWrappers::MPI::Vector                   right, solution;
  };


  /**
   * Preconditioner for a matrix that contact has made stiff. What is stiff lies
   * on the dofs of the contact surfaces, few of all: they are solved exactly,
   * S, before and after another preconditioner P for the whole matrix
   * (algebraic multigrid, say), x = S r,  x += P (r - A x),  x += S (r - A x).
   * The number of iterations hardly depends on the penalty. Symmetric if A and
   * P are: for SolverCG; for matrices that are not symmetric SolverGMRES.
   */
  template <class Preconditioner>
  class ContactPreconditioner
  {
  public:
    /// @param matrix,other Outlive this.
    /// @param contact_dofs Of the dofs that this rank owns, see
    ///                     ContactInterface::active_dofs().
    void
    initialize(const TrilinosWrappers::SparseMatrix &matrix,
               const Preconditioner                 &other,
               const IndexSet                       &contact_dofs)
    {
      A = &matrix;
      P = &other;
      S.initialize(matrix, contact_dofs);
      for (TrilinosWrappers::MPI::Vector *v : {&rest, &change})
        v->reinit(matrix.locally_owned_range_indices(),
                  matrix.get_mpi_communicator());
    }

    /// Precondition @p src.
    void
    vmult(TrilinosWrappers::MPI::Vector       &dst,
          const TrilinosWrappers::MPI::Vector &src) const
    {
      if (S.n_dofs() == 0)
        {
          P->vmult(dst, src);
          return;
        }
      dst = 0.;
      S.vmult_add(dst, src);
      A->residual(rest, dst, src);
      P->vmult(change, rest);
      dst += change;
      A->residual(rest, dst, src);
      S.vmult_add(dst, rest);
    }

    /// The exact part.
    const ContactBlock &
    contact_block() const
    {
      return S;
    }

  private:
    const TrilinosWrappers::SparseMatrix *A = nullptr;
    const Preconditioner                 *P = nullptr;
    ContactBlock                          S;
    mutable TrilinosWrappers::MPI::Vector rest, change;
  };
} // namespace MortarContact

#endif

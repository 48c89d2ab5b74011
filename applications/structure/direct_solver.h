// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_direct_solver_h
#define mortar_contact_structure_direct_solver_h

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>

namespace Structure
{
  using namespace dealii;

  /**
   * MUMPS, called directly: the order of elimination is found once for each
   * pattern of the matrix, and entries stay with the ranks that own them.
   * (Amesos' interface starts anew for each matrix and gathers it.) After
   * factorise(), it is the inverse of the matrix, a preconditioner for others.
   */
  class DirectSolver
  {
  public:
    explicit DirectSolver(const MPI_Comm communicator);
    ~DirectSolver();

    /**
     * Collective.
     * @param pattern A number that changes with the pattern of the matrix.
     * @return False if the matrix is singular.
     * @throw ExcMessage if memory does not suffice.
     */
    bool
    factorise(const TrilinosWrappers::SparseMatrix &matrix,
              const unsigned int                    pattern);

    /// Solve (last matrix) x = rhs, after a factorise() that returned true.
    /// Collective.
    void
    vmult(TrilinosWrappers::MPI::Vector       &x,
          const TrilinosWrappers::MPI::Vector &rhs) const;

  private:
    struct Data;
    std::unique_ptr<Data> data;
  };
} // namespace Structure

#endif

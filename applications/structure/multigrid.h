// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_multigrid_h
#define mortar_contact_structure_multigrid_h

#include "block_smoother.h"

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>
#include <vector>

struct ML_Struct;

namespace Structure
{
  /**
   * Algebraic multigrid for elastic bodies: one V-cycle, symmetric. On the
   * finest level, where nearly all the work is, BlockSmoother; below, smoothed
   * aggregation by ML, which knows the rigid body motions. What is below
   * outlives the matrix: one with other entries, of the same unknowns, takes
   * a new finest level only.
   */
  class Multigrid
  {
  public:
    /// @param matrix Outlives this, or the call of forget_matrix().
    /// @param rigid_body_modes Values of this rank's unknowns for each.
    Multigrid(const TrilinosWrappers::SparseMatrix   &matrix,
              const std::vector<std::vector<double>> &rigid_body_modes);

    /// The matrix will be gone.
    void
    forget_matrix()
    {
      finest.reset();
    }

    /// The matrix has new values, or after forget_matrix() there is another:
    /// the finest level follows, what is below stays as it is.
    void
    update(const TrilinosWrappers::SparseMatrix &matrix);

    void
    vmult(TrilinosWrappers::MPI::Vector       &dst,
          const TrilinosWrappers::MPI::Vector &src) const;

    /// Whether there are levels but the finest: else nothing outlives the
    /// matrix.
    bool
    has_levels() const;

  private:
    /// The correction of the levels below: in `rest` from residual to
    /// correction.
    void
    correct() const;

    std::unique_ptr<BlockSmoother>    finest;
    TrilinosWrappers::PreconditionAMG below;
    ML_Struct                        *ml; ///< Of `below`.
    mutable BlockSmoother::Values     x, b, r;
    mutable std::vector<double>       rest, coarse_rest, coarse; ///< For ML.
  };
} // namespace Structure

#endif

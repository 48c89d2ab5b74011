// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_multigrid_h
#define mortar_contact_structure_multigrid_h

#include "block_smoother.h"

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_vector.h>

namespace Structure
{
  /**
   * Algebraic multigrid for elastic bodies: one V-cycle, symmetric. On the
   * finest level, where nearly all the work is, BlockSmoother; below, smoothed
   * aggregation by ML, which knows the rigid body motions.
   */
  class Multigrid
  {
  public:
    /// @param matrix Outlives this; its values may change, its pattern not.
    /// @param rigid_body_modes Values of this rank's unknowns for each.
    Multigrid(const TrilinosWrappers::SparseMatrix   &matrix,
              const std::vector<std::vector<double>> &rigid_body_modes);

    /// The matrix has new values: the finest level follows, what is below stays
    /// as it is.
    void
    update();

    void
    vmult(TrilinosWrappers::MPI::Vector       &dst,
          const TrilinosWrappers::MPI::Vector &src) const;

  private:
    BlockSmoother                         finest;
    TrilinosWrappers::PreconditionAMG     below;
    mutable BlockSmoother::Values         x, b, r;
    mutable TrilinosWrappers::MPI::Vector rest;
  };
} // namespace Structure

#endif

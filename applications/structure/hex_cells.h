// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_hex_cells_h
#define mortar_contact_structure_hex_cells_h

#include "cell_batches.h"
#include "hex_kernel.h"
#include "solid_body.h"

#include <array>
#include <cstdint>
#include <vector>

namespace Structure
{
  /// The trilinear hexahedra of a neo-Hookean solid.
  class HexCells : public CellBatches<3>
  {
  public:
    /// Whether the body is one for which this is made.
    static bool
    fit(const SolidBody<3> &body);

    /// @param owned    Dofs of this rank.
    /// @param relevant Dofs of the ghosted vectors.
    HexCells(const SolidBody<3> &body,
             const IndexSet     &owned,
             const IndexSet     &relevant);

    unsigned int
    n_pressures() const override
    {
      return kernel.has_pressure ? cells.size() : 0;
    }

    void
    add_couplings(const types::global_dof_index    first,
                  const AffineConstraints<double> &constraints,
                  DynamicSparsityPattern          &pattern) const override;

    void
    set_matrix(const Matrix_t                  &matrix,
               const AffineConstraints<double> &constraints) override;

    std::string
    assemble(const Vector_t    &u,
             const Target      &target,
             PressureUnknowns  &pressures,
             const unsigned int first_pressure,
             const bool         reset) override;

    double
    energy(const Vector_t &u) const override;

  private:
    static constexpr unsigned int width   = HexKernel::width;
    static constexpr unsigned int n_nodes = HexKernel::n_nodes;
    static constexpr unsigned int n_dofs  = 3 * n_nodes;

    struct Cell
    {
      std::array<types::global_dof_index, n_nodes> dofs; ///< Of x; y, z follow.
      std::array<unsigned int, n_nodes>            ghosted; ///< In its vector.
      std::array<std::uint8_t, n_nodes> order; ///< Place among sorted dofs.
      bool                              is_owned = false; ///< All dofs are.
      bool is_plain = false; ///< And none is constrained.
    };

    /// What a dof is after the constraints: a sum of other dofs, by weights.
    using Entries = std::vector<std::pair<types::global_dof_index, double>>;
    static void
    resolve(const types::global_dof_index    dof,
            const AffineConstraints<double> &constraints,
            Entries                         &entries);

    /// Put cells from @p first on into the lanes, the last one again where
    /// there are fewer. @return How many there are.
    unsigned int
    fill(const unsigned int first,
         const double      *u_values,
         HexKernel::Cells  &in) const;

    /// Add one cell of a batch by the constraints.
    void
    add_constrained(const Cell              &cell,
                    const HexKernel::Result &result,
                    const unsigned int       lane,
                    const double             along_dv,
                    const Target            &target) const;

    /// Row of B of one cell.
    void
    set_derivative(const Cell                   &cell,
                   const HexKernel::Result      &result,
                   const unsigned int            lane,
                   const types::global_dof_index row,
                   const Target                 &target,
                   PressureUnknowns             &pressures) const;

    const SolidBody<3>                     &body;
    HexKernel                               kernel;
    types::global_dof_index                 first_owned = 0;
    std::vector<Cell>                       cells;
    std::vector<std::array<double, n_dofs>> positions; ///< Undeformed, by cell.

    /// By plain cell and pair of nodes: where the block's columns start in its
    /// rows. Rows start at row_begin, by owned dof.
    std::vector<std::array<std::uint16_t, n_nodes * n_nodes>> columns;
    double    *matrix_values = nullptr;
    const int *row_begin     = nullptr;
  };
} // namespace Structure

#endif

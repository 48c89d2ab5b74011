// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_cell_batches_h
#define mortar_contact_structure_cell_batches_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <string>

namespace Structure
{
  using namespace dealii;

  using Vector_t = TrilinosWrappers::MPI::Vector;
  using Matrix_t = TrilinosWrappers::SparseMatrix;

  /**
   * The pressures p of nearly incompressible cells, K (v/V - 1) at the end, as
   * unknowns beside the displacements (T. Sussman, K.-J. Bathe,
   * doi:10.1016/0045-7949(87)90265-3): Newton's linear system is
   *   [ A   B^T       ] [ du ]   [ r            ]
   *   [ B  -V/(K - k) ] [ dq ] = [ -(R + B du_0) ],
   *   R = v - V - V p/K,   dp = dq + k/V (B (du + du_0) + R),
   * with the share k of the bulk modulus K that is left in the matrix A, and
   * prescribed du_0. Its residual is not multiplied by K as that of the
   * condensed system (k = K), so that it may be solved roughly. All vectors are
   * by cell; the cells of a rank come one after the other.
   */
  struct PressureUnknowns
  {
    bool     are_on = false;
    IndexSet owned;
    Vector_t value;      ///< p, positive in tension [Pa].
    Vector_t residual;   ///< R [m^3].
    Vector_t prescribed; ///< B du_0 [m^3].
    Vector_t compliance; ///< V/(K - k) [m^3/Pa].
    Vector_t schur;      ///< V/(K - k) + V/(mu + k) [m^3/Pa].
    Vector_t in_matrix;  ///< k/V [Pa/m^3].
    Vector_t scale;      ///< mu/V^(1/3): makes forces of volumes [Pa/m].
    Vector_t update;     ///< dp of the last solve.
    Matrix_t derivative; ///< B: of volumes by free displacements [m^2].
  };

  /**
   * The cells of a body that are evaluated several at once and added to the
   * matrix without a detour. In statics only.
   */
  template <int dim>
  class CellBatches
  {
  public:
    virtual ~CellBatches() = default;

    /// Pressures that this rank has.
    virtual unsigned int
    n_pressures() const = 0;

    /// Entries of the matrix B, rows counted from @p first.
    virtual void
    add_couplings(const types::global_dof_index    first,
                  const AffineConstraints<double> &constraints,
                  DynamicSparsityPattern          &pattern) const = 0;

    /// A new matrix, with other constraints; its entries will not move.
    virtual void
    set_matrix(const Matrix_t                  &matrix,
               const AffineConstraints<double> &constraints) = 0;

    /// Where the parts of a cell go; null: not asked for.
    struct Target
    {
      const AffineConstraints<double> &constraints;
      Matrix_t                        *matrix; ///< As in set_matrix().
      Vector_t                        &rhs;    ///< Minus the forces.
      Vector_t                        &internal;
    };

    /**
     * Add forces (and tangent) at the displacements @p u.
     * @param first_pressure Of this body's, among this rank's.
     * @param reset The pressures first follow from the displacements.
     * @return Why this is impossible, or nothing.
     */
    virtual std::string
    assemble(const Vector_t    &u,
             const Target      &target,
             PressureUnknowns  &pressures,
             const unsigned int first_pressure,
             const bool         reset) = 0;

    /// Strain energy at the displacements @p u of this rank's cells [J].
    virtual double
    energy(const Vector_t &u) const = 0;
  };
} // namespace Structure

#endif

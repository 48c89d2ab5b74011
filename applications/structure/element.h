// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_element_h
#define mortar_contact_structure_element_h

#include <deal.II/base/symmetric_tensor.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Structure
{
  using namespace dealii;

  template <int dim>
  class SolidBody;

  /// Means over one cell, for output.
  struct CellState
  {
    SymmetricTensor<2, 3> stress;            ///< Cauchy [Pa]
    double                volume_ratio = 1.; ///< J
    double                energy       = 0.; ///< Strain energy of the cell [J]
  };

  /**
   * Internal forces and tangent of the cells of one body. Total Lagrangian:
   *   f_a = sum_q P grad N_a w_q,   K_ab = sum_q grad N_a A grad N_b w_q,
   * with the mean dilatation (Simo, Taylor & Pister 1985,
   * doi:10.1016/0045-7825(85)90033-7) on request: U(v/V) V in place of the
   * integral of U(J).
   */
  template <int dim>
  class Element
  {
  public:
    explicit Element(const SolidBody<dim> &body);

    /// @return Nothing is valid if this is false: det F <= 0 at some point.
    bool
    evaluate(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const Vector<double>                                 &u,
             const bool                                            with_tangent,
             Vector<double>                                       &forces,
             FullMatrix<double>                                   &tangent);

    /// Consistent mass matrix of a cell [kg].
    void
    mass(const typename DoFHandler<dim>::active_cell_iterator &cell,
         FullMatrix<double>                                   &matrix);

    /// Means of the cell of the last evaluate().
    const CellState &
    state() const
    {
      return cell_state;
    }

  private:
    const SolidBody<dim>     &body;
    FEValues<dim>             fe_values;
    std::vector<unsigned int> component; ///< By dof of the cell.
    CellState                 cell_state;
    std::vector<Tensor<2, 3>> F;
  };

  /// F at a point: I + sum_a u_a grad N_a, in plane strain for dim = 2.
  template <int dim>
  Tensor<2, 3>
  deformation_gradient(const FEValuesBase<dim>         &fe_values,
                       const std::vector<unsigned int> &component,
                       const Vector<double>            &u,
                       const unsigned int               q);

  /// Components of the cell's dofs.
  template <int dim>
  std::vector<unsigned int>
  components_of(const FiniteElement<dim> &fe);
} // namespace Structure

#endif

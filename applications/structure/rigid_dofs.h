// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_rigid_dofs_h
#define mortar_contact_structure_rigid_dofs_h

#include "expression.h"
#include "rigid_parameters.h"

#include <mortar_contact/host/rigid_body.h>

#include <memory>
#include <vector>

namespace Structure
{
  /**
   * The dofs of a rigid body with free motions: which are free, what loads
   * them, and what the others do. Rotations are lengths, see
   * RigidBody::set_dofs().
   */
  template <int dim>
  class RigidDofs
  {
  public:
    static constexpr unsigned int n = MortarContact::RigidBody<dim>::n_dofs;

    /// @param length Of the scene [m].
    RigidDofs(const std::shared_ptr<MortarContact::RigidBody<dim>> &body,
              const RigidParameters                                &parameters,
              const double                                          length);

    /// Give the body the dofs first, first + 1, ...
    void
    set_first(const types::global_dof_index first);

    types::global_dof_index
    first() const
    {
      return body->dofs()[0];
    }

    bool
    is_free(const unsigned int i) const
    {
      return free[i];
    }

    /// Value of a motion that is not free.
    double
    prescribed(const unsigned int i, const double time);

    /// Load on a motion: force, or moment over the length.
    double
    load(const unsigned int i, const double time);

  private:
    std::shared_ptr<MortarContact::RigidBody<dim>> body;
    Tensor<1, dim>                                 centre;
    double                                         length;
    std::vector<char>                              free;
    std::vector<Expression<dim>>                   motions, loads;
    Tensor<1, 3>                                   axis;
  };
} // namespace Structure

#endif

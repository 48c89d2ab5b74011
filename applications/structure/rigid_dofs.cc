// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rigid_dofs.h"

#include <algorithm>

namespace Structure
{
  template <int dim>
  RigidDofs<dim>::RigidDofs(
    const std::shared_ptr<MortarContact::RigidBody<dim>> &body,
    const RigidParameters                                &p,
    const double                                          length)
    : body(body)
    , centre(p.turning_point<dim>())
    , length(length)
    , axis({0., 0., 1.})
  {
    const std::string where = "Rigid bodies/" + p.name + "/";
    const auto        has   = [&](const std::string &motion) {
      return std::find(p.free_motions.begin(), p.free_motions.end(), motion) !=
             p.free_motions.end();
    };
    for (unsigned int i = 0; i < dim; ++i)
      {
        const std::string component(1, "xyz"[i]);
        free.push_back(has(component));
        motions.emplace_back(p.translation[i], where + "Move " + component);
        loads.emplace_back(p.force[i], where + "Force " + component);
      }
    for (unsigned int k = (dim == 2 ? 2 : 0); k < 3; ++k)
      {
        const std::string component(1, "xyz"[k]);
        free.push_back(has("rotation " + component) ||
                       (dim == 2 && has("rotation")));
        motions.emplace_back(p.rotation_angle, where + "Rotation angle");
        loads.emplace_back(p.moment[k], where + "Moment " + component);
      }
    AssertThrow(dim == 3 ||
                  (!has("z") && !has("rotation x") && !has("rotation y")),
                ExcMessage(
                  "'Free motions' has a motion of three dimensions but "
                  "'Dimension' is 2; expected x, y, rotation."));
    if (!p.rotation_axis.empty())
      for (unsigned int i = 0; i < 3; ++i)
        axis[i] = p.rotation_axis[i];
    axis /= axis.norm();
  }


  template <int dim>
  void
  RigidDofs<dim>::set_first(const types::global_dof_index first)
  {
    std::array<types::global_dof_index, n> dofs;
    for (unsigned int i = 0; i < n; ++i)
      dofs[i] = first + i;
    body->set_dofs(dofs, centre, length);
  }


  template <int dim>
  double
  RigidDofs<dim>::prescribed(const unsigned int i, const double time)
  {
    // counted from the start, where the body has its place already
    const double value =
      motions[i].value(Point<dim>(), time) - motions[i].value(Point<dim>(), 0.);
    return (i < dim) ? value : length * axis[i + 3 - n] * value;
  }


  template <int dim>
  double
  RigidDofs<dim>::load(const unsigned int i, const double time)
  {
    const double value = loads[i].value(Point<dim>(), time);
    return (i < dim) ? value : value / length;
  }


  template class RigidDofs<2>;
  template class RigidDofs<3>;
} // namespace Structure

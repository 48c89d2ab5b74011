// SPDX-License-Identifier: LGPL-2.1-or-later

// What ContactInterface does about rigid bodies.

#include <mortar_contact/host/contact_interface.h>
#include <mortar_contact/search/material_locator.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace MortarContact
{
  template <int dim>
  void
  ContactInterface<dim>::add_rigid(const unsigned int                     side,
                                   const std::shared_ptr<RigidBody<dim>> &body)
  {
    AssertThrow(body != nullptr,
                ExcMessage("Interface '" + name +
                           "': there is no rigid body to add."));
    begin_adding();
    rigid_bodies.push_back(body);
    if (body->surface)
      {
        AssertThrow(side == 1,
                    ExcMessage("Interface '" + name + "': the rigid body '" +
                               body->name +
                               "' has a smooth surface without facets and can "
                               "be primary only."));
        AssertThrow(!obstacle,
                    ExcMessage("Interface '" + name + "': '" + obstacle->name +
                               "' and '" + body->name +
                               "' are both primary; a rigid body with a smooth "
                               "surface must be the only primary. Expected one "
                               "interface for each."));
        obstacle = body;
        return;
      }
    // each rank brings its share
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    auto              &all     = surfaces[side].rigid_bodies;
    all.push_back(body);
    for (unsigned int f = 0; f < body->facets.size(); ++f)
      if (f * n_ranks / body->facets.size() == rank)
        {
          SurfaceFacet<dim> facet;
          facet.n_vertices = body->facets[f].size();
          facet.label      = {body->name, f};
          for (unsigned int a = 0; a < facet.n_vertices; ++a)
            {
              const unsigned int v           = body->facets[f][a];
              facet.vertices[a].reference    = body->vertices[v];
              facet.vertices[a].rigid_body   = all.size() - 1;
              facet.vertices[a].rigid_vertex = n_rigid_vertices + v;
            }
          extracted[side].push_back(facet);
        }
    n_rigid_vertices += body->vertices.size();
  }


  template <int dim>
  void
  ContactInterface<dim>::add_secondary(
    const std::shared_ptr<RigidBody<dim>> &body)
  {
    add_rigid(0, body);
  }


  template <int dim>
  void
  ContactInterface<dim>::add_primary(
    const std::shared_ptr<RigidBody<dim>> &body)
  {
    add_rigid(1, body);
  }


  template <int dim>
  void
  ContactInterface<dim>::check_tool_normals()
  {
    // Angles this close to tangential say nothing, as a cosine.
    constexpr double            judged  = 0.3;
    InitialReport              &initial = last_report.initial;
    ContactSurface<dim>        &tool    = surfaces[1];
    std::vector<unsigned int>   wrong;
    std::vector<Tensor<1, dim>> centres;
    for (const auto &s : surfaces[0].skin.facets)
      centres.push_back(centre(s.current));
    const PointLocator<dim> blank(centres);
    for (unsigned int p = 0; p < tool.skin.facets.size(); ++p)
      {
        if (!tool.vertex(p, 0).row.empty())
          continue; // faces of solids point outwards
        // it must face the nearest facet of the blank
        const Facet<dim>    &facet   = tool.skin.facets[p].current;
        const Tensor<1, dim> c       = centre(facet);
        const Tensor<1, dim> w       = centre_normal(facet);
        const auto           nearest = blank.find(c, diameter(facet));
        const Tensor<1, dim> n =
          centre_normal(surfaces[0].skin.facets[*nearest].current);
        if (w * n > judged * w.norm() * n.norm())
          wrong.push_back(p);
      }
    if (wrong.empty())
      return;

    // A closed body whose normals point outwards is right, also where its far
    // side points away from the blank.
    std::map<unsigned int, double> volume;
    for (unsigned int p = 0; p < tool.skin.facets.size(); ++p)
      if (tool.vertex(p, 0).row.empty())
        volume[tool.vertex(p, 0).rigid_body] += 0.;
    std::map<unsigned int, std::map<std::set<unsigned int>, int>> ridges;
    for (unsigned int p = 0; p < tool.skin.facets.size(); ++p)
      if (tool.vertex(p, 0).row.empty())
        {
          const unsigned int n = tool.skin.facets[p].current.n_vertices;
          for (unsigned int a = 0; a < n; ++a)
            {
              std::set<unsigned int> ridge = {tool.skin.vertices[p][a]};
              if (dim == 3)
                ridge.insert(tool.skin.vertices[p][(a + 1) % n]);
              ++ridges[tool.vertex(p, 0).rigid_body][ridge];
            }
          volume[tool.vertex(p, 0).rigid_body] +=
            centre(tool.skin.facets[p].current) *
            centre_normal(tool.skin.facets[p].current);
        }
    std::set<unsigned int> fine;
    for (const auto &[body, of_body] : ridges)
      if (volume[body] > 0. &&
          std::all_of(of_body.begin(), of_body.end(), [](const auto &r) {
            return r.second == 2;
          }))
        fine.insert(body);
    wrong.erase(std::remove_if(wrong.begin(),
                               wrong.end(),
                               [&](const unsigned int p) {
                                 return fine.count(
                                          tool.vertex(p, 0).rigid_body) > 0;
                               }),
                wrong.end());
    if (wrong.empty())
      return;

    if (parameters.kind != ContactParameters::Kind::forming_surface_to_surface)
      {
        initial.n_facing_away = wrong.size();
        return;
      }
    if (parameters.tool_normals == ContactParameters::ToolNormals::check)
      {
        std::ostringstream message;
        message
          << "Interface '" << name << "': the normals of " << wrong.size()
          << " facets of the tool do not point to the blank, the first is "
          << "facet " << tool.labels[wrong[0]].cell << " of '"
          << tool.labels[wrong[0]].part << "' at ("
          << centre(tool.skin.facets[wrong[0]].current)
          << "). Turn them in the mesh, or set 'Tool normals' to 'turn'.";
        AssertThrow(false, ExcMessage(message.str()));
      }
    initial.n_turned = wrong.size();
    for (auto &facet : extracted[1])
      for (const unsigned int p : wrong)
        if (facet.vertices[0].row.empty() &&
            facet.label.part == tool.labels[p].part &&
            facet.label.cell == tool.labels[p].cell)
          std::reverse(facet.vertices.begin(),
                       facet.vertices.begin() + facet.n_vertices);
    build_surface(1);
    tool.move([](const auto) { return 0.; });
  }


  template <int dim>
  void
  ContactInterface<dim>::place_rigid_bodies(const double time)
  {
    for (const auto &body : rigid_bodies)
      if (body->has_dofs())
        {
          std::array<double, RigidBody<dim>::n_dofs> of_body;
          for (unsigned int i = 0; i < of_body.size(); ++i)
            of_body[i] = value(body->dofs()[i]);
          body->move_to(of_body);
        }
      else
        body->move(time);
  }


  template <int dim>
  void
  ContactInterface<dim>::check_motion_of_tools(const double time)
  {
    largest_tool_step = 1.;
    const bool moves =
      std::any_of(rigid_bodies.begin(), rigid_bodies.end(), [](const auto &b) {
        return b->prescribed && !b->has_dofs();
      });
    if (!moves || !is_set_up || time == committed_time)
      return;
    const std::vector<double> now = values;
    largest_tool_step =
      safe_step_between(committed_values.empty() ? now : committed_values,
                        committed_time,
                        now,
                        time);
    values = now;
  }


  template <int dim>
  double
  ContactInterface<dim>::safe_step_between(const std::vector<double> &from,
                                           const double               from_time,
                                           const std::vector<double> &to,
                                           const double               to_time)
  {
    values = to;
    place_rigid_bodies(to_time);
    std::vector<Facet<dim>> moved[2];
    for (unsigned int side = 0; side < 2; ++side)
      moved[side] =
        surfaces[side].moved([&](const auto dof) { return value(dof); });
    RigidMotion<dim> end;
    if (obstacle)
      end = obstacle->motion();
    values = from;
    place_rigid_bodies(from_time);
    for (auto &surface : surfaces)
      surface.move([&](const auto dof) { return value(dof); });

    double step = 1.;
    for (unsigned int i = 0; i < sweeps.size(); ++i)
      step =
        std::min(step,
                 obstacle ? sweeps[i]->safe_step_to_obstacle(moved[0], end) :
                            sweeps[i]->safe_step(moved[side_of(i, 0)],
                                                 moved[side_of(i, 1)]));
    return Utilities::MPI::min(step, communicator);
  }


  template void
  ContactInterface<2>::add_secondary(const std::shared_ptr<RigidBody<2>> &);
  template void
  ContactInterface<2>::add_primary(const std::shared_ptr<RigidBody<2>> &);
  template void
  ContactInterface<2>::add_rigid(const unsigned int,
                                 const std::shared_ptr<RigidBody<2>> &);
  template void
  ContactInterface<2>::check_tool_normals();
  template void
  ContactInterface<2>::place_rigid_bodies(const double);
  template void
  ContactInterface<2>::check_motion_of_tools(const double);
  template double
  ContactInterface<2>::safe_step_between(const std::vector<double> &,
                                         const double,
                                         const std::vector<double> &,
                                         const double);
  template void
  ContactInterface<3>::add_secondary(const std::shared_ptr<RigidBody<3>> &);
  template void
  ContactInterface<3>::add_primary(const std::shared_ptr<RigidBody<3>> &);
  template void
  ContactInterface<3>::add_rigid(const unsigned int,
                                 const std::shared_ptr<RigidBody<3>> &);
  template void
  ContactInterface<3>::check_tool_normals();
  template void
  ContactInterface<3>::place_rigid_bodies(const double);
  template void
  ContactInterface<3>::check_motion_of_tools(const double);
  template double
  ContactInterface<3>::safe_step_between(const std::vector<double> &,
                                         const double,
                                         const std::vector<double> &,
                                         const double);
} // namespace MortarContact

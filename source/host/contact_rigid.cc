// SPDX-License-Identifier: LGPL-2.1-or-later

// What ContactInterface does about rigid bodies.

#include <mortar_contact/host/contact_interface.h>
#include <mortar_contact/search/material_locator.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
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
    constexpr double judged  = 0.3;
    InitialReport   &initial = last_report.initial;

    // Step 1: which facets do not face the nearest facet of the blank? All
    // ranks know the tool, each knows a part of the blank. Faces of solids
    // point outwards.
    struct ToolFacet
    {
      const RigidBody<dim> *body;
      unsigned int          number; ///< In the body.
      Facet<dim>            facet;  ///< Where it is.
    };
    std::vector<ToolFacet> tool;
    for (const auto &body : surfaces[1].rigid_bodies)
      for (unsigned int f = 0; f < body->facets.size(); ++f)
        {
          Facet<dim> facet;
          facet.n_vertices = body->facets[f].size();
          for (unsigned int a = 0; a < facet.n_vertices; ++a)
            facet.x[a] =
              body->motion().place(body->vertices[body->facets[f][a]]);
          tool.push_back({body.get(), f, facet});
        }
    const Skin<dim>            &blank = surfaces[0].skin;
    std::vector<Tensor<1, dim>> centres;
    for (unsigned int f = 0; f < blank.n_own; ++f)
      centres.push_back(centre(blank.facets[f].current));
    const PointLocator<dim>   locator(centres);
    std::vector<double>       nearest(tool.size(),
                                std::numeric_limits<double>::max());
    std::vector<unsigned int> faces_away(tool.size(), 0);
    for (unsigned int p = 0; p < tool.size(); ++p)
      {
        const Tensor<1, dim> c     = centre(tool[p].facet);
        const Tensor<1, dim> w     = centre_normal(tool[p].facet);
        const auto           found = locator.find(c, diameter(tool[p].facet));
        if (!found)
          continue;
        const Tensor<1, dim> n = centre_normal(blank.facets[*found].current);
        nearest[p]             = (centres[*found] - c).norm_square();
        faces_away[p]          = w * n > judged * w.norm() * n.norm();
      }
    std::vector<double> nearest_of_all(tool.size());
    Utilities::MPI::min(nearest, communicator, nearest_of_all);
    for (unsigned int p = 0; p < tool.size(); ++p)
      if (nearest[p] > nearest_of_all[p])
        faces_away[p] = 0;
    Utilities::MPI::max(faces_away, communicator, faces_away);

    // Step 2: a closed body whose normals point outwards is right, also where
    // its far side points away from the blank.
    const auto is_closed = [](const RigidBody<dim> &body) {
      std::map<std::set<unsigned int>, int> ridges;
      double                                volume = 0.;
      for (const auto &vertices : body.facets)
        {
          Facet<dim> facet;
          facet.n_vertices = vertices.size();
          for (unsigned int a = 0; a < vertices.size(); ++a)
            {
              std::set<unsigned int> ridge = {vertices[a]};
              if (dim == 3)
                ridge.insert(vertices[(a + 1) % vertices.size()]);
              ++ridges[ridge];
              facet.x[a] = body.vertices[vertices[a]];
            }
          volume += centre(facet) * centre_normal(facet);
        }
      return volume > 0. &&
             std::all_of(ridges.begin(), ridges.end(), [](const auto &r) {
               return r.second == 2;
             });
    };
    std::map<const RigidBody<dim> *, bool> fine;
    std::vector<ToolFacet>                 wrong;
    for (unsigned int p = 0; p < tool.size(); ++p)
      if (faces_away[p])
        {
          const auto of_body = fine.try_emplace(tool[p].body, false);
          if (of_body.second)
            of_body.first->second = is_closed(*tool[p].body);
          if (!of_body.first->second)
            wrong.push_back(tool[p]);
        }
    if (wrong.empty())
      return;

    // Step 3: say so, or turn them.
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
          << "facet " << wrong[0].number << " of '" << wrong[0].body->name
          << "' at (" << centre(wrong[0].facet)
          << "). Turn them in the mesh, or set 'Tool normals' to 'turn'.";
        AssertThrow(false, ExcMessage(message.str()));
      }
    initial.n_turned = wrong.size();
    for (auto &facet : extracted[1])
      for (const ToolFacet &w : wrong)
        if (facet.vertices[0].row.empty() && facet.label.part == w.body->name &&
            facet.label.cell == w.number)
          std::reverse(facet.vertices.begin(),
                       facet.vertices.begin() + facet.n_vertices);
    build_surface(1);
    surfaces[1].move([](const auto) { return 0.; });
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
    std::vector<double> now    = values;
    std::vector<double> before = has_committed_values ? committed_values : now;
    largest_tool_step = safe_step_between(before, committed_time, now, time);
    values            = now;
  }


  template <int dim>
  double
  ContactInterface<dim>::safe_step_between(std::vector<double> &from,
                                           const double         from_time,
                                           std::vector<double> &to,
                                           const double         to_time)
  {
    std::vector<Facet<dim>> moved[2];
    RigidMotion<dim>        end;
    const auto              go = [&]() {
      values = to;
      place_rigid_bodies(to_time);
      for (unsigned int side = 0; side < 2; ++side)
        moved[side] =
          surfaces[side].moved([&](const auto dof) { return value(dof); });
      if (obstacle)
        end = obstacle->motion();
      values = from;
      place_rigid_bodies(from_time);
      for (auto &surface : surfaces)
        surface.move([&](const auto dof) { return value(dof); });
    };
    go();
    // facets of other ranks that are far now may be near on the way
    const auto regions = [&]() {
      std::vector<std::vector<Box<dim>>> result;
      for (unsigned int i = 0; i < sweeps.size(); ++i)
        result.push_back(sweeps[i]->swept_regions(moved[side_of(i, 0)]));
      return result;
    };
    const auto boxes = [&]() {
      std::array<std::vector<Box<dim>>, 2> result;
      for (unsigned int side = 0; side < 2; ++side)
        {
          const Skin<dim> &skin = surfaces[side].skin;
          for (unsigned int f = 0; f < skin.n_own; ++f)
            result[side].push_back(
              box_around(skin.facets[f].current, moved[side][f]));
        }
      return result;
    };
    if (bring_near(regions, boxes, {&from, &to}))
      go();

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
  ContactInterface<2>::safe_step_between(std::vector<double> &,
                                         const double,
                                         std::vector<double> &,
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
  ContactInterface<3>::safe_step_between(std::vector<double> &,
                                         const double,
                                         std::vector<double> &,
                                         const double);
} // namespace MortarContact

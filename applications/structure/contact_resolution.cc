// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_resolution.h"

#include "numbers_of.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Structure
{
  namespace
  {
    /// Mid-surfaces may be nearer than their thickness by this share of it.
    constexpr double nearer = 0.05;

    /// Differences of penetrations and extent along the last axis of the facets
    /// in contact.
    template <int dim>
    std::pair<double, double>
    jump_and_height(const MortarContact::ContactInterface<dim> &interface,
                    const MPI_Comm                              communicator)
    {
      double jump = 0., low = std::numeric_limits<double>::max(),
             high = std::numeric_limits<double>::lowest();
      struct Range
      {
        double low  = std::numeric_limits<double>::max();
        double high = 0.;
      };
      std::map<std::pair<unsigned int, unsigned int>, Range> at_vertex;
      for (const auto &state :
           MortarContact::facet_states(interface, communicator))
        {
          if (state.penetration <= 0.)
            continue;
          const double size =
            std::pow(MortarContact::area(state.current), 1. / (dim - 1));
          for (unsigned int a = 0; a < state.current.n_vertices; ++a)
            {
              Range &range = at_vertex[{state.side, state.vertices[a]}];
              range.low    = std::min(range.low, state.penetration / size);
              range.high   = std::max(range.high, state.penetration / size);
              low          = std::min(low, state.current.x[a][dim - 1]);
              high         = std::max(high, state.current.x[a][dim - 1]);
            }
        }
      for (const auto &[vertex, range] : at_vertex)
        jump = std::max(jump, range.high - range.low);
      return {jump, std::max(0., high - low)};
    }
  } // namespace


  template <int dim>
  ContactResolution<dim>::ContactResolution(const Model<dim> &model)
  {
    std::vector<MidTriangle>                                      triangles;
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> parts;
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      for (MidTriangle triangle : model.bodies[b]->mid_surface())
        {
          triangle.part =
            parts.try_emplace({b, triangle.part}, parts.size()).first->second;
          triangles.push_back(triangle);
        }
    if (!triangles.empty())
      shells = std::make_unique<MidSurfaces>(triangles, model.communicator);
  }


  template <int dim>
  void
  ContactResolution<dim>::watch(const Model<dim> &model)
  {
    before = std::move(last);
    last.clear();
    for (const auto &interface : model.interfaces)
      last.emplace_back(interface->report().force,
                        interface->report().active_area);
  }


  template <int dim>
  void
  ContactResolution<dim>::measure(const Model<dim> &model, const Vector_t &u)
  {
    interfaces.clear();
    for (unsigned int i = 0; i < model.interfaces.size(); ++i)
      {
        const auto &r = model.interfaces[i]->report();
        Resolved    resolved;
        resolved.name = r.name;
        // a penetration is a negative gap; nothing in front is far away
        resolved.smallest_gap =
          r.largest_penetration > 0. ? -r.largest_penetration :
          r.smallest_gap < std::numeric_limits<double>::max() ?
                                       r.smallest_gap :
                                       std::numeric_limits<double>::infinity();
        resolved.largest_gap =
          r.largest_gap > std::numeric_limits<double>::lowest() ?
            r.largest_gap :
            std::numeric_limits<double>::infinity();
        std::tie(resolved.gap_jump, resolved.height) =
          jump_and_height(*model.interfaces[i], model.communicator);
        if (before.size() == last.size() && r.active_area > 0.)
          resolved.change =
            std::max((last[i].first - before[i].first).norm() /
                       std::max(last[i].first.norm(),
                                std::numeric_limits<double>::min()),
                     std::abs(last[i].second - before[i].second) /
                       r.active_area);
        interfaces.push_back(resolved);
      }
    if (shells)
      shell_state = shells->state(Vector<double>(u));
  }


  template <int dim>
  std::vector<std::pair<std::string, double>>
  ContactResolution<dim>::record() const
  {
    std::vector<std::pair<std::string, double>> row;
    for (const Resolved &i : interfaces)
      {
        row.emplace_back(i.name + ":smallest_gap", i.smallest_gap);
        row.emplace_back(i.name + ":largest_gap", i.largest_gap);
        row.emplace_back(i.name + ":gap_jump", i.gap_jump);
        row.emplace_back(i.name + ":height", i.height);
        row.emplace_back(i.name + ":last_change", i.change);
      }
    if (shells)
      {
        row.emplace_back("shells:distance_over_thickness",
                         shell_state.distance);
        row.emplace_back("shells:crossing_triangles", shell_state.n_crossing);
      }
    return row;
  }


  template <int dim>
  std::vector<std::string>
  ContactResolution<dim>::lines() const
  {
    std::vector<std::string> result;
    for (const Resolved &i : interfaces)
      if (i.height > 0.)
        result.push_back("  '" + i.name + "' is resolved: smallest gap " +
                         number(i.smallest_gap) + ", largest " +
                         number(i.largest_gap) + ", jumps of " +
                         number(100. * i.gap_jump, 2) +
                         " % of a facet, changed by " + number(i.change, 2) +
                         " in the last iteration");
    if (shells)
      {
        result.push_back(
          "  mid-surfaces " +
          std::string(
            shell_state.distance < MidSurfaces::farthest ? "" : "at least ") +
          number(shell_state.distance) + " thicknesses apart, " +
          std::to_string(shell_state.n_crossing) + " crossings");
        if (shell_state.distance < 1. - nearer)
          result.push_back(
            "  WARNING: mid-surfaces are nearer than " + number(1. - nearer) +
            " of their thickness: a stiffer contact or smaller steps keep them "
            "apart; nothing can be meshed between them");
      }
    return result;
  }


  template class ContactResolution<2>;
  template class ContactResolution<3>;
} // namespace Structure

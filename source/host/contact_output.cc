// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/contact_output.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <tuple>

namespace MortarContact
{
  namespace
  {
    /// Patches of one interface; DataOutInterface writes them.
    template <int dim>
    class SkinOutput : public DataOutInterface<dim - 1, dim>
    {
    public:
      explicit SkinOutput(const std::vector<FacetState<dim>> &states)
      {
        for (const FacetState<dim> &state : states)
          {
            DataOutBase::Patch<dim - 1, dim> patch;
            const unsigned int               n = state.current.n_vertices;
            patch.reference_cell = (dim == 2) ? ReferenceCells::Line :
                                   (n == 3)   ? ReferenceCells::Triangle :
                                                ReferenceCells::Quadrilateral;
            patch.n_subdivisions = 1;
            patch.data.reinit(7, n);
            for (unsigned int k = 0; k < n; ++k)
              {
                // deal.II's order of quadrilaterals is lexicographic
                const unsigned int a = (n == 4 && k >= 2) ? 5 - k : k;
                patch.vertices[k]    = Point<dim>(state.current.x[a]);
                patch.data(0, k)     = state.pressure[a];
                patch.data(1, k)     = state.penetration;
                patch.data(2, k)     = state.relative;
                patch.data(3, k)     = state.side;
                patch.data(4, k)     = state.label.cell;
                patch.data(5, k)     = state.shear[a];
                patch.data(6, k)     = static_cast<double>(state.status);
              }
            patch.patch_index = patches.size();
            patches.push_back(patch);
          }
      }

    private:
      const std::vector<DataOutBase::Patch<dim - 1, dim>> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        return {"pressure",
                "penetration",
                "penetration_over_release",
                "side",
                "cell",
                "shear",
                "status"};
      }

      std::vector<DataOutBase::Patch<dim - 1, dim>> patches;
    };
  } // namespace


  template <int dim>
  std::vector<FacetState<dim>>
  own_facet_states(const ContactInterface<dim> &contact,
                   const MPI_Comm               communicator)
  {
    constexpr unsigned int V = max_vertices<dim>;
    using Status             = typename FacetState<dim>::Status;
    // Step 1: forces on the vertices of facets, by side, from all sweeps: the
    // share that each sweep carries has no meaning of its own. Those on facets
    // of other ranks go there: number, forces, depths and status.
    constexpr unsigned int n = V * dim + 3;
    std::vector<double>    of_side[2];
    for (unsigned int side = 0; side < 2; ++side)
      of_side[side].resize(contact.surface(side).skin.facets.size() * n, 0.);
    contact.for_each_pair([&](const unsigned int i, const auto &pair) {
      const auto  &block  = pair.block;
      const Status status = contact.ties() != nullptr && block.overlap == 0. &&
                                block.penetration == 0. ?
                              Status::tied :
                            block.slip_area > 0. ? Status::slip :
                                                   Status::stick;
      for (unsigned int role = 0; role < 2; ++role)
        {
          const unsigned int side = contact.side_of(i, role);
          const unsigned int f    = (role == 0) ? pair.secondary : pair.primary;
          if (f >= contact.surface(side).skin.facets.size())
            continue; // an obstacle
          double *v = &of_side[side][f * n];
          for (unsigned int k = 0; k < V * dim; ++k)
            v[k] += block.residual[role * max_facet_components<dim> + k];
          v += V * dim;
          v[0] = std::max(v[0], block.penetration);
          v[1] = std::max(v[1], block.relative_penetration);
          v[2] = std::max(v[2], static_cast<double>(status));
        }
    });
    std::vector<FacetState<dim>> states;
    for (unsigned int side = 0; side < 2; ++side)
      {
        const ContactSurface<dim> &surface = contact.surface(side);
        const Skin<dim>           &skin    = surface.skin;
        std::vector<double>       &values  = of_side[side];
        std::map<unsigned int,
                 std::pair<std::vector<unsigned int>, std::vector<double>>>
          to_others;
        for (unsigned int f = skin.n_own; f < skin.facets.size(); ++f)
          if (values[f * n + V * dim + 2] != 0.)
            {
              const auto [rank, number] = surface.origin(f);
              to_others[rank].first.push_back(number);
              to_others[rank].second.insert(to_others[rank].second.end(),
                                            values.begin() + f * n,
                                            values.begin() + (f + 1) * n);
            }
        for (const auto &[rank, received] :
             Utilities::MPI::some_to_some(communicator, to_others))
          for (std::size_t k = 0; k < received.first.size(); ++k)
            {
              double       *v = &values[received.first[k] * n];
              const double *w = &received.second[k * n];
              for (unsigned int c = 0; c < V * dim; ++c)
                v[c] += w[c];
              for (unsigned int c = V * dim; c < n; ++c)
                v[c] = std::max(v[c], w[c]);
            }

        // Step 2: sums at the vertices: normal force, area, tangential force.
        std::map<types::global_dof_index, std::vector<double>> at_vertices;
        for (unsigned int f = 0; f < skin.n_own; ++f)
          {
            const Facet<dim>    &facet  = skin.facets[f].current;
            const Tensor<1, dim> w      = centre_normal(facet);
            const Tensor<1, dim> normal = w / w.norm();
            for (unsigned int a = 0; a < facet.n_vertices; ++a)
              {
                auto &sums = at_vertices[skin.vertices[f][a]];
                sums.resize(2 + dim, 0.);
                Tensor<1, dim> F;
                for (unsigned int c = 0; c < dim; ++c)
                  F[c] = values[f * n + a * dim + c];
                const Tensor<1, dim> tangential = F - (F * normal) * normal;
                sums[0] += F * normal;
                sums[1] += area(facet) / facet.n_vertices;
                for (unsigned int c = 0; c < dim; ++c)
                  sums[2 + c] += tangential[c];
              }
          }
        sum_at_vertices(at_vertices, communicator);

        // Step 3: pressures.
        for (unsigned int f = 0; f < skin.n_own; ++f)
          {
            const double   *depths = &values[f * n + V * dim];
            FacetState<dim> state;
            state.current     = skin.facets[f].current;
            state.reference   = skin.facets[f].reference;
            state.penetration = depths[0];
            state.relative    = depths[1] / contact.parameters.largest_share();
            state.status      = static_cast<Status>(std::lround(depths[2]));
            state.side        = side;
            state.modulus     = surface.cell_modulus[f];
            state.label       = surface.labels[f];
            state.face        = surface.faces[f];
            state.vertices    = skin.vertices[f];
            for (unsigned int a = 0; a < state.current.n_vertices; ++a)
              {
                const auto    &sums = at_vertices[skin.vertices[f][a]];
                Tensor<1, dim> tangential;
                for (unsigned int c = 0; c < dim; ++c)
                  tangential[c] = sums[2 + c];
                state.pressure[a] = sums[0] / sums[1];
                state.shear[a]    = tangential.norm() / sums[1];
              }
            states.push_back(state);
          }
      }
    return states;
  }


  namespace
  {
    /// States of several ranks in the order of surfaces on one rank.
    template <int dim>
    std::vector<FacetState<dim>>
    in_order(const std::vector<std::vector<FacetState<dim>>> &of_ranks)
    {
      std::vector<FacetState<dim>> states;
      for (const auto &of_rank : of_ranks)
        states.insert(states.end(), of_rank.begin(), of_rank.end());
      std::sort(states.begin(), states.end(), [](const auto &a, const auto &b) {
        return std::tie(a.side, a.label.part, a.label.cell, a.face) <
               std::tie(b.side, b.label.part, b.label.cell, b.face);
      });
      return states;
    }
  } // namespace


  template <int dim>
  std::vector<FacetState<dim>>
  facet_states(const ContactInterface<dim> &contact,
               const MPI_Comm               communicator)
  {
    return in_order(
      Utilities::MPI::all_gather(communicator,
                                 own_facet_states(contact, communicator)));
  }


  template <int dim>
  void
  write_contact_vtu(const ContactInterface<dim> &contact,
                    const std::string           &file,
                    const MPI_Comm               communicator)
  {
    const auto states =
      in_order(Utilities::MPI::gather(communicator,
                                      own_facet_states(contact, communicator)));
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    std::ofstream out(file);
    SkinOutput<dim>(states).write_vtu(out);
    AssertThrow(out, ExcMessage("The file '" + file + "' cannot be written."));
  }


  template std::vector<FacetState<2>>
  own_facet_states(const ContactInterface<2> &, const MPI_Comm);
  template std::vector<FacetState<3>>
  own_facet_states(const ContactInterface<3> &, const MPI_Comm);
  template std::vector<FacetState<2>>
  facet_states(const ContactInterface<2> &, const MPI_Comm);
  template std::vector<FacetState<3>>
  facet_states(const ContactInterface<3> &, const MPI_Comm);
  template void
  write_contact_vtu(const ContactInterface<2> &,
                    const std::string &,
                    const MPI_Comm);
  template void
  write_contact_vtu(const ContactInterface<3> &,
                    const std::string &,
                    const MPI_Comm);
} // namespace MortarContact

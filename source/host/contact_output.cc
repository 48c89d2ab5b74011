// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/contact_output.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <cmath>
#include <fstream>
#include <map>

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
  facet_states(const ContactInterface<dim> &contact,
               const MPI_Comm               communicator)
  {
    // Step 1: forces on the vertices of all facets, by side, from all sweeps:
    // the share that each sweep carries has no meaning of its own.
    constexpr unsigned int V = max_vertices<dim>;
    std::vector<double>    force[2], depth[2];
    for (unsigned int side = 0; side < 2; ++side)
      {
        const unsigned int n = contact.surface(side).skin.facets.size();
        force[side].resize(n * V * dim, 0.);
        depth[side].resize(3 * n, 0.);
      }
    contact.for_each_pair([&](const unsigned int i, const auto &pair) {
      using Status        = typename FacetState<dim>::Status;
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
          for (unsigned int k = 0; k < V * dim; ++k)
            force[side][f * V * dim + k] +=
              block.residual[role * max_facet_components<dim> + k];
          double *d = &depth[side][3 * f];
          d[0]      = std::max(d[0], block.penetration);
          d[1]      = std::max(d[1], block.relative_penetration);
          d[2]      = std::max(d[2], static_cast<double>(status));
        }
    });

    // Step 2: pressures, from the sums at the vertices.
    std::vector<FacetState<dim>> states;
    for (unsigned int side = 0; side < 2; ++side)
      {
        Utilities::MPI::sum(force[side], communicator, force[side]);
        Utilities::MPI::max(depth[side], communicator, depth[side]);

        struct Sums
        {
          double         normal = 0., area = 0.;
          Tensor<1, dim> tangential;
        };
        const ContactSurface<dim>   &surface = contact.surface(side);
        const Skin<dim>             &skin    = surface.skin;
        std::map<unsigned int, Sums> at_vertex;
        for (unsigned int f = 0; f < skin.facets.size(); ++f)
          {
            const Facet<dim>    &facet = skin.facets[f].current;
            const Tensor<1, dim> w     = centre_normal(facet);
            const Tensor<1, dim> n     = w / w.norm();
            for (unsigned int a = 0; a < facet.n_vertices; ++a)
              {
                Sums          &sums = at_vertex[skin.vertices[f][a]];
                Tensor<1, dim> F;
                for (unsigned int c = 0; c < dim; ++c)
                  F[c] = force[side][(f * V + a) * dim + c];
                sums.normal += F * n;
                sums.tangential += F - (F * n) * n;
                sums.area += area(facet) / facet.n_vertices;
              }
          }
        for (unsigned int f = 0; f < skin.facets.size(); ++f)
          {
            FacetState<dim> state;
            state.current     = skin.facets[f].current;
            state.reference   = skin.facets[f].reference;
            state.penetration = depth[side][3 * f];
            state.relative =
              depth[side][3 * f + 1] / contact.parameters.largest_share();
            state.status = static_cast<typename FacetState<dim>::Status>(
              std::lround(depth[side][3 * f + 2]));
            state.side  = side;
            state.label = surface.labels[f];
            for (unsigned int a = 0; a < state.current.n_vertices; ++a)
              {
                const Sums &sums  = at_vertex[skin.vertices[f][a]];
                state.pressure[a] = sums.normal / sums.area;
                state.shear[a]    = sums.tangential.norm() / sums.area;
              }
            states.push_back(state);
          }
      }
    return states;
  }


  template <int dim>
  void
  write_contact_vtu(const ContactInterface<dim> &contact,
                    const std::string           &file,
                    const MPI_Comm               communicator)
  {
    const auto states = facet_states(contact, communicator);
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    std::ofstream out(file);
    SkinOutput<dim>(states).write_vtu(out);
    AssertThrow(out, ExcMessage("The file '" + file + "' cannot be written."));
  }


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

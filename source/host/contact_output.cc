// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/contact_output.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

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
            patch.data.reinit(5, n);
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
                "cell"};
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
        force[side].resize(n * V, 0.);
        depth[side].resize(2 * n, 0.);
      }
    for (unsigned int i = 0; i < contact.n_sweeps(); ++i)
      for (const auto &pair : contact.sweep(i).active_pairs())
        for (unsigned int role = 0; role < 2; ++role)
          {
            const unsigned int side = (role == 0) ? i : 1 - i;
            const unsigned int f = (role == 0) ? pair.secondary : pair.primary;
            const Tensor<1, dim> w =
              centre_normal(contact.surface(side).skin.facets[f].current);
            for (unsigned int a = 0; a < V; ++a)
              for (unsigned int c = 0; c < dim; ++c)
                force[side][f * V + a] +=
                  pair.block
                    .residual[role * max_facet_components<dim> + a * dim + c] *
                  w[c] / w.norm();
            double &d        = depth[side][2 * f];
            double &relative = depth[side][2 * f + 1];
            d                = std::max(d, pair.block.penetration);
            relative = std::max(relative, pair.block.relative_penetration);
          }

    // Step 2: pressures, from the sums at the vertices.
    std::vector<FacetState<dim>> states;
    for (unsigned int side = 0; side < 2; ++side)
      {
        Utilities::MPI::sum(force[side], communicator, force[side]);
        Utilities::MPI::max(depth[side], communicator, depth[side]);

        const ContactSurface<dim> &surface = contact.surface(side);
        const Skin<dim>           &skin    = surface.skin;
        std::map<unsigned int, std::pair<double, double>> at_vertex;
        for (unsigned int f = 0; f < skin.facets.size(); ++f)
          {
            const Facet<dim> &facet = skin.facets[f].current;
            for (unsigned int a = 0; a < facet.n_vertices; ++a)
              {
                auto &sums = at_vertex[skin.vertices[f][a]];
                sums.first += force[side][f * V + a];
                sums.second += area(facet) / facet.n_vertices;
              }
          }
        for (unsigned int f = 0; f < skin.facets.size(); ++f)
          {
            FacetState<dim> state;
            state.current     = skin.facets[f].current;
            state.reference   = skin.facets[f].reference;
            state.penetration = depth[side][2 * f];
            state.relative =
              depth[side][2 * f + 1] / contact.parameters.largest_share();
            state.side  = side;
            state.label = surface.labels[f];
            for (unsigned int a = 0; a < state.current.n_vertices; ++a)
              {
                const auto &sums  = at_vertex[skin.vertices[f][a]];
                state.pressure[a] = sums.first / sums.second;
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

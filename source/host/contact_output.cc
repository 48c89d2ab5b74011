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
            const unsigned int n = state.current.n_vertices;
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
  facet_states(const ContactInterface<dim> &contact, const MPI_Comm communicator)
  {
    std::vector<FacetState<dim>> states;
    for (unsigned int i = 0; i < contact.n_sweeps(); ++i)
      {
        const ContactSurface<dim> &surface  = contact.surface(i);
        const Skin<dim>           &skin     = surface.skin;
        const unsigned int         n_facets = skin.facets.size();

        // forces on the facets' vertices by this sweep, and depths
        constexpr unsigned int V = max_vertices<dim>;
        std::vector<double>    force(n_facets * V, 0.), depth(2 * n_facets, 0.);
        for (const auto &pair : contact.sweep(i).active_pairs())
          {
            const unsigned int   f = pair.secondary;
            const Tensor<1, dim> w = centre_normal(skin.facets[f].current);
            for (unsigned int a = 0; a < V; ++a)
              for (unsigned int c = 0; c < dim; ++c)
                force[f * V + a] +=
                  pair.block.residual[a * dim + c] * w[c] / w.norm();
            depth[2 * f] = std::max(depth[2 * f], pair.block.penetration);
            depth[2 * f + 1] =
              std::max(depth[2 * f + 1], pair.block.relative_penetration);
          }
        Utilities::MPI::sum(force, communicator, force);
        Utilities::MPI::max(depth, communicator, depth);

        // each sweep carries its share of the pressure
        std::map<unsigned int, std::pair<double, double>> at_vertex;
        for (unsigned int f = 0; f < n_facets; ++f)
          for (unsigned int a = 0; a < skin.facets[f].current.n_vertices; ++a)
            {
              auto &sums = at_vertex[skin.vertices[f][a]];
              sums.first += contact.n_sweeps() * force[f * V + a];
              sums.second += area(skin.facets[f].current) /
                             skin.facets[f].current.n_vertices;
            }
        for (unsigned int f = 0; f < n_facets; ++f)
          {
            FacetState<dim> state;
            state.current     = skin.facets[f].current;
            state.reference   = skin.facets[f].reference;
            state.penetration = depth[2 * f];
            state.relative =
              depth[2 * f + 1] / contact.parameters.largest_share();
            state.side  = i;
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
    AssertThrow(out,
                ExcMessage("The file '" + file + "' cannot be written."));
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

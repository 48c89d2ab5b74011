// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/contact_surface.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace MortarContact
{
  template <int dim>
  void
  ContactSurface<dim>::build(std::vector<SurfaceFacet<dim>> local_facets,
                             const SurfaceStiffness        &stiffness,
                             const MPI_Comm                 communicator)
  {
    for (auto &f : local_facets)
      f.owner = Utilities::MPI::this_mpi_process(communicator);

    // Step 1: all facets everywhere, in an order that does not depend on ranks.
    std::vector<SurfaceFacet<dim>> facets;
    for (auto &of_rank : Utilities::MPI::all_gather(communicator, local_facets))
      std::move(of_rank.begin(), of_rank.end(), std::back_inserter(facets));
    std::sort(facets.begin(), facets.end(), [](const auto &a, const auto &b) {
      return std::tie(a.label.part, a.label.cell, a.face, a.subfacet) <
             std::tie(b.label.part, b.label.cell, b.face, b.subfacet);
    });

    // a face that was selected twice counts once
    facets.erase(
      std::unique(
        facets.begin(),
        facets.end(),
        [](const auto &a, const auto &b) {
          return a.vertices[0].key() == b.vertices[0].key() &&
                 std::tie(a.label.part, a.label.cell, a.face, a.subfacet) ==
                   std::tie(b.label.part, b.label.cell, b.face, b.subfacet);
        }),
      facets.end());

    // Step 2: one number per vertex.
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    std::map<types::global_dof_index, unsigned int> numbers;
    std::map<std::string, unsigned int>             parts;
    skin = {};
    vertices.clear();
    facet_vertices.clear();
    labels.clear();
    cell_modulus.clear();
    cell_length.clear();
    for (const auto &f : facets)
      {
        ContactFacet<dim> facet;
        facet.reference.n_vertices                           = f.n_vertices;
        std::array<unsigned int, max_vertices<dim>> of_facet = {};
        std::array<unsigned int, max_vertices<dim>> keys     = {};
        for (unsigned int a = 0; a < f.n_vertices; ++a)
          {
            const SurfaceVertex<dim> &v = f.vertices[a];
            const auto inserted = numbers.try_emplace(v.key(), vertices.size());
            if (inserted.second)
              vertices.push_back(v);
            of_facet[a]          = inserted.first->second;
            keys[a]              = v.key();
            facet.reference.x[a] = v.reference;
          }
        facet.current        = facet.reference;
        facet.surface_offset = stiffness.offset;
        skin.facets.push_back(facet);
        skin.vertices.push_back(keys);
        skin.is_owned.push_back(f.owner == rank);
        skin.parts.push_back(
          parts.try_emplace(f.label.part, parts.size()).first->second);
        facet_vertices.push_back(of_facet);
        labels.push_back(f.label);
        const bool is_rigid = f.modulus == 0.;
        cell_modulus.push_back(
          is_rigid || stiffness.modulus == 0. ? f.modulus : stiffness.modulus);
        cell_length.push_back(
          is_rigid ?
            0. :
          stiffness.length > 0. ?
            stiffness.length :
            (stiffness.use_shortest_edge ? f.shortest_edge : f.length));
      }

    // Step 3: compliance l/K and length at the vertices.
    std::vector<double> total_area(vertices.size()),
      compliance(vertices.size()), length(vertices.size());
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        const double a = area(skin.facets[f].reference);
        for (unsigned int v = 0; v < facets[f].n_vertices; ++v)
          {
            const unsigned int i = facet_vertices[f][v];
            total_area[i] += a;
            if (cell_modulus[f] > 0.)
              compliance[i] += a * cell_length[f] / cell_modulus[f];
            length[i] += a * cell_length[f];
          }
      }
    for (unsigned int f = 0; f < facets.size(); ++f)
      for (unsigned int v = 0; v < facets[f].n_vertices; ++v)
        {
          const unsigned int i         = facet_vertices[f][v];
          skin.facets[f].compliance[v] = compliance[i] / total_area[i];
          skin.facets[f].length[v]     = length[i] / total_area[i];
        }
  }


  template <int dim>
  Tensor<1, dim>
  ContactSurface<dim>::position(
    const SurfaceVertex<dim>                             &v,
    const std::function<double(types::global_dof_index)> &displacement) const
  {
    if (v.row.empty())
      return rigid_bodies[v.rigid_body]->motion().place(v.reference);
    Tensor<1, dim> x = v.reference;
    for (const auto &entry : v.row)
      for (unsigned int i = 0; i < dim; ++i)
        x[i] += entry.weight * displacement(entry.dofs[i]);
    return x;
  }


  template <int dim>
  std::vector<Facet<dim>>
  ContactSurface<dim>::moved(
    const std::function<double(types::global_dof_index)> &displacement) const
  {
    std::vector<Tensor<1, dim>> x;
    x.reserve(vertices.size());
    for (const auto &v : vertices)
      x.push_back(position(v, displacement));
    std::vector<Facet<dim>> result(skin.facets.size());
    for (unsigned int f = 0; f < result.size(); ++f)
      {
        result[f].n_vertices = skin.facets[f].current.n_vertices;
        for (unsigned int a = 0; a < result[f].n_vertices; ++a)
          result[f].x[a] = x[facet_vertices[f][a]];
      }
    return result;
  }


  template <int dim>
  void
  ContactSurface<dim>::move(
    const std::function<double(types::global_dof_index)> &displacement)
  {
    const std::vector<Facet<dim>> facets = moved(displacement);
    for (unsigned int f = 0; f < facets.size(); ++f)
      skin.facets[f].current = facets[f];
  }


  template <int dim>
  std::vector<types::global_dof_index>
  ContactSurface<dim>::dofs() const
  {
    std::vector<types::global_dof_index> result;
    for (const auto &v : vertices)
      for (const auto &entry : v.row)
        result.insert(result.end(), entry.dofs.begin(), entry.dofs.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }


  template class ContactSurface<2>;
  template class ContactSurface<3>;
} // namespace MortarContact

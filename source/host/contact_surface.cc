// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/contact_surface.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace MortarContact
{
  void
  sum_at_vertices(
    std::map<types::global_dof_index, std::vector<double>> &at_vertices,
    const MPI_Comm                                          communicator)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    if (n_ranks == 1)
      return;
    // each vertex is added up on the rank that its key says
    using Keys = std::vector<types::global_dof_index>;
    std::map<unsigned int, std::pair<Keys, std::vector<double>>> parts;
    for (const auto &[key, values] : at_vertices)
      {
        auto &[keys, flat] = parts[key % n_ranks];
        keys.push_back(key);
        flat.insert(flat.end(), values.begin(), values.end());
      }
    const auto received = Utilities::MPI::some_to_some(communicator, parts);
    std::map<types::global_dof_index, std::vector<double>> sums;
    for (const auto &[rank, part] : received)
      {
        const auto &[keys, flat] = part;
        const std::size_t n      = flat.size() / keys.size();
        for (std::size_t k = 0; k < keys.size(); ++k)
          {
            auto &sum = sums[keys[k]];
            sum.resize(n, 0.);
            for (std::size_t i = 0; i < n; ++i)
              sum[i] += flat[k * n + i];
          }
      }
    std::map<unsigned int, std::vector<double>> answers;
    for (const auto &[rank, part] : received)
      for (const auto key : part.first)
        answers[rank].insert(answers[rank].end(),
                             sums[key].begin(),
                             sums[key].end());
    for (const auto &[rank, flat] :
         Utilities::MPI::some_to_some(communicator, answers))
      {
        const Keys       &keys = parts[rank].first;
        const std::size_t n    = flat.size() / keys.size();
        for (std::size_t k = 0; k < keys.size(); ++k)
          at_vertices[keys[k]].assign(flat.begin() + k * n,
                                      flat.begin() + (k + 1) * n);
      }
  }


  template <int dim>
  void
  ContactSurface<dim>::append(const SurfaceFacet<dim> &f,
                              const double             modulus,
                              const double             length)
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
    facet.surface_offset = offset;
    skin.facets.push_back(facet);
    skin.vertices.push_back(keys);
    const auto part =
      std::lower_bound(parts.begin(), parts.end(), f.label.part);
    Assert(part != parts.end() && *part == f.label.part, ExcInternalError());
    skin.parts.push_back(part - parts.begin());
    facet_vertices.push_back(of_facet);
    labels.push_back(f.label);
    faces.emplace_back(f.face, f.subfacet);
    cell_modulus.push_back(modulus);
    cell_length.push_back(length);
  }


  template <int dim>
  void
  ContactSurface<dim>::build(std::vector<SurfaceFacet<dim>> facets,
                             const SurfaceStiffness        &stiffness,
                             const MPI_Comm                 communicator)
  {
    // Step 1: an order that does not depend on ranks.
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

    // Step 2: one number per vertex, and per part on all ranks.
    std::set<std::string> names;
    for (const auto &f : facets)
      names.insert(f.label.part);
    for (const auto &of_rank : Utilities::MPI::all_gather(
           communicator, std::vector<std::string>(names.begin(), names.end())))
      names.insert(of_rank.begin(), of_rank.end());
    parts.assign(names.begin(), names.end());
    rank   = Utilities::MPI::this_mpi_process(communicator);
    offset = stiffness.offset;
    skin   = {};
    vertices.clear();
    facet_vertices.clear();
    numbers.clear();
    labels.clear();
    faces.clear();
    cell_modulus.clear();
    cell_length.clear();
    origins.clear();
    for (const auto &f : facets)
      {
        const bool is_rigid = f.modulus == 0.;
        append(f,
               is_rigid || stiffness.modulus == 0. ? f.modulus :
                                                     stiffness.modulus,
               is_rigid                    ? 0. :
               stiffness.length > 0.       ? stiffness.length :
               stiffness.use_shortest_edge ? f.shortest_edge :
                                             f.length);
      }
    skin.n_own = facets.size();

    // Step 3: compliance l/K and length at the vertices: sums of areas, and of
    // both times area.
    std::map<types::global_dof_index, std::vector<double>> sums;
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        const double a = area(skin.facets[f].reference);
        for (unsigned int v = 0; v < facets[f].n_vertices; ++v)
          {
            auto &sum = sums[skin.vertices[f][v]];
            sum.resize(3, 0.);
            sum[0] += a;
            if (cell_modulus[f] > 0.)
              sum[1] += a * cell_length[f] / cell_modulus[f];
            sum[2] += a * cell_length[f];
          }
      }
    sum_at_vertices(sums, communicator);
    SkinSizes &sizes     = skin.sizes;
    sizes.largest_offset = std::abs(offset);
    double diameters     = 0.;
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        diameters += diameter(skin.facets[f].reference);
        for (unsigned int v = 0; v < facets[f].n_vertices; ++v)
          {
            const auto  &sum        = sums[skin.vertices[f][v]];
            const double compliance = sum[1] / sum[0];
            const double length     = sum[2] / sum[0];

            skin.facets[f].compliance[v] = compliance;
            skin.facets[f].length[v]     = length;
            sizes.largest_compliance =
              std::max(sizes.largest_compliance, compliance);
            sizes.largest_length = std::max(sizes.largest_length, length);
          }
      }
    sizes.largest_compliance =
      Utilities::MPI::max(sizes.largest_compliance, communicator);
    sizes.largest_length =
      Utilities::MPI::max(sizes.largest_length, communicator);
    sizes.mean_diameter = Utilities::MPI::sum(diameters, communicator) /
                          Utilities::MPI::sum(double(skin.n_own), communicator);
  }


  template <int dim>
  NearFacet<dim>
  ContactSurface<dim>::describe(const unsigned int f) const
  {
    AssertIndexRange(f, skin.n_own);
    NearFacet<dim> near;
    near.facet.n_vertices = skin.facets[f].reference.n_vertices;
    for (unsigned int a = 0; a < near.facet.n_vertices; ++a)
      near.facet.vertices[a] = vertex(f, a);
    near.facet.label                               = labels[f];
    std::tie(near.facet.face, near.facet.subfacet) = faces[f];
    near.facet.modulus                             = cell_modulus[f];
    near.facet.length                              = cell_length[f];
    near.current                                   = skin.facets[f].current;
    near.compliance                                = skin.facets[f].compliance;
    near.length                                    = skin.facets[f].length;
    near.number                                    = f;
    return near;
  }


  template <int dim>
  void
  ContactSurface<dim>::add(const NearFacet<dim> &near, const unsigned int rank)
  {
    append(near.facet, near.facet.modulus, near.facet.length);
    skin.facets.back().current    = near.current;
    skin.facets.back().compliance = near.compliance;
    skin.facets.back().length     = near.length;
    origins.emplace_back(rank, near.number);
  }


  template <int dim>
  std::pair<unsigned int, unsigned int>
  ContactSurface<dim>::origin(const unsigned int f) const
  {
    if (f < skin.n_own)
      return {rank, f};
    return origins[f - skin.n_own];
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

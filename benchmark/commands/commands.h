// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_COMMANDS_H
#define BENCHMARK_COMMANDS_H

namespace CLI {
class App;
}

namespace benchmark {

// Each in a file of its name. What the tables are, and how they are measured, is in README.md.
void add_models_command(CLI::App& app);
void add_levels_command(CLI::App& app);
void add_backends_command(CLI::App& app);
void add_published_command(CLI::App& app);
void add_order_command(CLI::App& app);
void add_scaling_command(CLI::App& app);
void add_foreign_command(CLI::App& app);
void add_segmentation_command(CLI::App& app);
void add_checks_command(CLI::App& app);
void add_retrieval_command(CLI::App& app);
void add_texture_command(CLI::App& app);
void add_locate_command(CLI::App& app);
void add_mass_command(CLI::App& app);

} // namespace benchmark

#endif // BENCHMARK_COMMANDS_H

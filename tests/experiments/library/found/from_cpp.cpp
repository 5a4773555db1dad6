/* SPDX-License-Identifier: GPL-3.0-or-later */
/* from_cpp.cpp - libfretwork from C++: prints its version, and where a particle is after 10 steps.
 */
#include <fretwork.h>

#include <iostream>

int main()
{
    fw_simulation_def def = fw_simulation_def_default();
    fw_simulation *simulation;
    def.scenario = "free-particle";
    if (fw_simulation_create(&simulation, &def, nullptr) != FW_OK) return 1;
    if (fw_simulation_advance(simulation, 10, nullptr) != FW_OK) return 1;
    std::cout << fw_version() << ": " << fw_simulation_body(simulation, 0).x[0] << '\n';
    fw_simulation_destroy(simulation);
}

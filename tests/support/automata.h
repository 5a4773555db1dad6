/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automata.h - definitions of elastic automata of some shapes. */
#ifndef FW_AUTOMATA_H
#define FW_AUTOMATA_H

#include "tests/support/laws.h"

#include "core/automaton/elastic_automaton.h"

static inline fw_sites rectangle(int columns, int rows)
{
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, columns, rows, NULL), FW_OK);
    return sites;
}

static inline fw_sites mask(const char *text)
{
    fw_sites sites;
    assert_int_equal(fw_sites_mask(&sites, text, NULL), FW_OK);
    return sites;
}

static inline fw_elastic_automaton_def def_of(const fw_sites *sites, double c1, double c2)
{
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = sites;
    def.speeds = (fw_automaton_speeds){c1, c2};
    return def;
}

#endif

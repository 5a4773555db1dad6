/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_formula.c - formulas of named numbers: where they stand in a setting, their values, and what
 * is said of wrong ones. */
#include "tests/support/laws.h"

#include "experiments/text/substitution.h"
#include "tests/support/scratch.h"

#include <stdlib.h>
#include <string.h>

static void formulas_stand_for_their_values(void **state)
{
    static const fw_variable variables[] = {{"A", 2.5}, {"m", 4}};
    static const struct {
        const char *setting, *wanted;
        bool A, m; /* are named */
    } rows[] = {
        {"a.b=A", "a.b=2.5", true, false},
        {"a.b=[0, 24*A]", "a.b=[0, 60]", true, false},
        {"a.b=[-24*A,A]", "a.b=[-60,2.5]", true, false},
        {"a.b=-A", "a.b=-2.5", true, false},
        {"a.b=[1e3*A]", "a.b=[2500]", true, false},
        {"a.b=3*m*0.1", "a.b=1.2000000000000002", false, true},
        {"a.b=0*A - 0", "a.b=0", true, false},
        {"a.b={x: A, y: 'A'}", "a.b={x: 2.5, y: '2.5'}", true, false},
        {"a.b=0.1 / A", "a.b=0.04", true, false},
        {"a.b=[ sqrt(A^2 + m^2 - 6) , 7]", "a.b=[ 4.031128874149275 , 7]", true, true},
        {"a.b=[max(A, m), min(A, m)]", "a.b=[4, 2.5]", true, true},
        {"a.b=rint(10/m)", "a.b=3", false, true},
        {"a.b=(A > m ? 1 : 2)", "a.b=2", true, true},
        {"a.b=2*pi*m", "a.b=25.132741228718345", false, true},
        /* A key, other names, and formulas without a parameter. */
        {"A.b={A: 1, AA: 2}", "A.b={A: 1, AA: 2}", false, false},
        {"a.b=[AB, A2, _A, 1e3]", "a.b=[AB, A2, _A, 1e3]", false, false},
        {"a.b=x:y", "a.b=x:y", false, false},
        {"a.A", "a.A", false, false},
        {"a.b={A:\tA}", "a.b={A:\t2.5}", true, false},
        {"a.b=A:", "a.b=A:", false, false},
        {"a.b=[2e3*A, 2e+3*A, 1e-1]", "a.b=[5000, 5000, 1e-1]", true, false},
    };
    (void)state;
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n) {
        bool used[2] = {false};
        char *out;
        assert_fine(fw_substitution_write(rows[n].setting, variables, 2, &out, used, &error));
        assert_string_equal(out, rows[n].wanted);
        assert_int_equal(used[0], rows[n].A);
        assert_int_equal(used[1], rows[n].m);
        free(out);
    }
}

static void wrong_formulas_get_their_sentence(void **state)
{
    static const fw_variable variables[] = {{"speed", 0}, {"m", 4}};
    static const struct {
        const char *formula, *sentence;
    } rows[] = {
        {"2*sped + m",
         "the formula '2*sped + m' has the unknown name 'sped'; did you mean 'speed'?"},
        {"m*foo(m)", "the formula 'm*foo(m)' has the unknown name 'foo', expected a parameter or "
                     "a function such as sqrt"},
        {"2 m", "the formula '2 m' cannot be read from its character 3 on, 'm'"},
        {"24**m", "the formula '24**m' cannot be read from its character 4 on, '*m'"},
        {"m*", "the formula 'm*' ends where more is expected"},
        {"sqrt(m", "the formula 'sqrt(m' cannot be read to its end"},
        {"m$2", "the formula 'm$2' cannot be read from its character 2 on, '$2'"},
        {"m)", "the formula 'm)' cannot be read from its character 2 on, ')'"},
        {"m=3", "the formula 'm=3' has a single '=', expected none"},
        {"=m", "the formula '=m' has a single '=', expected none"},
        {"m <= 4 = 1", "the formula 'm <= 4 = 1' has a single '=', expected none"},
        {"0.1/speed",
         "the formula '0.1/speed' is infinite where speed=0, expected a finite number"},
        {"sqrt(speed-m)", "the formula 'sqrt(speed-m)' is not a number where speed=0, m=4, "
                          "expected a finite number"},
    };
    double value;
    (void)state;
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n) {
        assert_int_equal(fw_formula_evaluate(rows[n].formula, strlen(rows[n].formula), variables, 2,
                                             &value, &error),
                         FW_BAD_INPUT);
        assert_string_equal(error.sentence, rows[n].sentence);
    }
    char lengthy[1002];
    memset(lengthy, '1', 1001);
    assert_refused(fw_formula_evaluate(lengthy, 1001, variables, 2, &value, &error), FW_BAD_INPUT,
                   "has 1001 bytes, expected at most 1000");
}

/* An exponent has digits; an e without them is a name. */
static void exponents_are_no_names(void **state)
{
    (void)state;
    static const fw_variable variables[] = {{"e", 1}, {"E", 2}, {"e3", 3}, {"m", 4}};
    static const struct {
        const char *text;
        int number; /* of the first variable that is named, or -1 */
        size_t end;
    } rows[] = {{"2e3", -1, 3}, {"2e+3*m", 3, 6}, {"2e-3", -1, 4}, {"2e", 0, 2},
                {"2e+", 0, 2},  {"2E-m", 1, 2},   {"2e*m", 0, 2},  {".5e3m", 3, 5},
                {"e3", 2, 2},   {"2.e3", -1, 4},  {"2*me+m", 3, 6}};
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        size_t end = 99;
        assert_int_equal(fw_formula_find(rows[n].text, strlen(rows[n].text), 0, variables, 4, &end),
                         rows[n].number);
        assert_int_equal(end, rows[n].end);
    }
}

static void names_of_formulas_are_taken(void **state)
{
    static const char *const fine[] = {"A", "p", "M0", "k_1", "e", "x", "pie", "Sin"};
    static const char *const taken[] = {"sin", "sqrt", "min", "pi", "rint",
                                        "2v",  "",     "a-b", "_x", "a b"};
    (void)state;
    for (size_t n = 0; n < sizeof fine / sizeof fine[0]; ++n)
        assert_fine(fw_formula_check_name(fine[n], &error));
    for (size_t n = 0; n < sizeof taken / sizeof taken[0]; ++n)
        assert_int_equal(fw_formula_check_name(taken[n], &error), FW_BAD_INPUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formulas_stand_for_their_values),
        cmocka_unit_test(wrong_formulas_get_their_sentence),
        cmocka_unit_test(exponents_are_no_names),
        cmocka_unit_test(names_of_formulas_are_taken),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

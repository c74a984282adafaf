/* build/golden: the tests' group `golden` alone, quick to build for one compiler after another. */
#include "tests/unit/test.h"

int main(void)
{
    check_group("golden");
    test_golden();
    return check_summary() ? 0 : 1;
}

/* Time stepping with a fixed step. options = {step}. */
#include "stepping.h"

static double step_length(const Scene *scene, const double *options, const State *s)
{
    (void)scene;
    (void)s;
    return options[0];
}

#include "loop.h"

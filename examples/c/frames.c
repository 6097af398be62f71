/* A camera that refocuses while it films: the PSF of each frame, by one plan that allocates nothing from frame to frame. */
#include <lommel.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { side = 33 };

int main(int arguments, char** argument) {
    const int frames = arguments > 1 ? atoi(argument[1]) : 250;
    /* 50 mm, f/1.8, pixels of 3.45 um, 550 nm; the object stands still at 2 m. */
    const double focal = 50e-3, number = 1.8, pixel = 3.45e-6, wavelength = 550e-9, object = 2.0, pi = 3.14159265358979323846;
    static double psf[side][side];
    /* The sensor is up to 2 % farther away than the focal length, which changes lambda*N by as much: one plan for all. */
    lommel_plan* plan = lommel_plan_new(side, side, pixel / (wavelength * number), 1e-6);
    if (plan == NULL || lommel_plan_integrate(plan, 1) != LOMMEL_OK) {
        fprintf(stderr, "%s\n", lommel_message());
        return 1;
    }
    double sharpest = 0.0, worst = 0.0, at = 0.0;
    for (int frame = 0; frame < frames; ++frame) {
        const double focus = 1.5 + frame / (double)frames; /* metres, the distance that the lens is focused at */
        const double sensor = 1.0 / (1.0 / focal - 1.0 / focus), image = 1.0 / (1.0 / focal - 1.0 / object);
        /* The wavefront's curvature, relative to that which converges on the sensor, at the edge of the pupil. */
        const double radius = focal / (2.0 * number);
        const double defocus = pi / wavelength * radius * radius * (1.0 / image - 1.0 / sensor) / 2.0;
        double bound;
        if (lommel_psf_radial(plan, 1, 1, &defocus, &psf[0][0], &bound) != LOMMEL_OK) {
            fprintf(stderr, "frame %d: %s\n", frame, lommel_message());
            return 1;
        }
        worst = fmax(worst, bound);
        if (psf[side / 2][side / 2] > sharpest) {
            sharpest = psf[side / 2][side / 2];
            at = focus;
        }
    }
    lommel_plan_free(plan);
    printf("%d frames, sharpest at %.2f m with %.4f of the light on one pixel; errors of at most %.1e of the peak\n", frames,
           at, sharpest, worst);
    return 0;
}

/* The C interface of the core: plans of windows, and PSFs of circular and annular pupils with their error bounds; and, at the
 * end, depth of frames that differ in focus.
 *
 * A plan holds what all PSFs of a program have in common: the window, the pixel, the tolerance, the aperture. It is made
 * once; each call then writes images into arrays of the caller.
 *
 *     lommel_plan *plan = lommel_plan_new(33, 33, 0.5, 1e-6);
 *     double defocus = 3.0, image[33 * 33], bound;
 *     if (lommel_psf_radial(plan, 1, 1, &defocus, image, &bound) != LOMMEL_OK) {
 *         fprintf(stderr, "%s\n", lommel_message());
 *     }
 *     lommel_plan_free(plan);
 *
 * Conventions. Lengths are in units of lambda*N, the wavelength times the f-number: a pixel of p metres is p / (lambda*N).
 * Phases are in radians; rho is the pupil radius, from 0 on the axis to 1 at the edge. Arrays are contiguous, in the order
 * [image][row][column]. The optical axis is in the middle of the pixel (height / 2, width / 2), counted from 0, unless
 * lommel_plan_center() puts it elsewhere.
 *
 * Errors. Functions that return an int return LOMMEL_OK or a code below; lommel_message() then says what was wrong. Arrays
 * of results are undefined after an error. No exception leaves the library.
 *
 * Threads. Any number of threads may compute with one plan at the same time; the functions that set a property of it must
 * not run meanwhile. A call that is repeated allocates no memory if its pupils are radially symmetric and the plan has one
 * thread, which is the default.
 *
 * Versions. Before version 1.0 a minor version may change this interface, after that a major one: the name of the shared
 * library has these numbers. Other versions only add functions. LOMMEL_ABI changes with the interface; compare it with
 * lommel_abi() where the library is loaded at run time. */
#ifndef LOMMEL_H
#define LOMMEL_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(LOMMEL_BUILDS_C)
#define LOMMEL_API __declspec(dllexport)
#elif defined(__GNUC__)
#define LOMMEL_API __attribute__((visibility("default")))
#else
#define LOMMEL_API
#endif

#ifdef __cplusplus
#define LOMMEL_NOTHROW noexcept
extern "C" {
#else
#define LOMMEL_NOTHROW
#endif

#define LOMMEL_ABI 1

/* What functions return. */
#define LOMMEL_OK 0
#define LOMMEL_INVALID 1   /* an argument is out of range */
#define LOMMEL_TOLERANCE 2 /* the tolerance cannot be met for this pupil */
#define LOMMEL_LIMIT 3     /* phase, window or tilt is beyond the limits of the method */
#define LOMMEL_MEMORY 4    /* memory could not be allocated */
#define LOMMEL_INTERNAL 5  /* any other failure: a fault of the library */

/* What values are, for lommel_plan_normalize(). */
#define LOMMEL_ENERGY 0 /* fraction of the light that falls on a pixel; of samples, the intensity times its area (default) */
#define LOMMEL_STREHL 1 /* intensity over the peak of the same aperture without aberration */
#define LOMMEL_PEAK 2   /* the largest value of each image is 1 */

typedef struct lommel_plan lommel_plan;

/* LOMMEL_ABI and version of the library that is loaded. */
LOMMEL_API int lommel_abi(void) LOMMEL_NOTHROW;
LOMMEL_API const char* lommel_version(void) LOMMEL_NOTHROW;

/* What was wrong in the last call of this thread that failed; valid until its next one. */
LOMMEL_API const char* lommel_message(void) LOMMEL_NOTHROW;

/* A plan of windows of height x width pixels, `pixel` the pitch in units of lambda*N, for errors of at most `tol` times the
 * peak of each PSF, 1e-12 to 0.1. NULL where an argument is out of range or memory is short. */
LOMMEL_API lommel_plan* lommel_plan_new(int32_t height, int32_t width, double pixel, double tol) LOMMEL_NOTHROW;
LOMMEL_API void lommel_plan_free(lommel_plan* plan) LOMMEL_NOTHROW;

/* Row and column of the optical axis, in pixels from the middle of the first, each within 1e6. */
LOMMEL_API int lommel_plan_center(lommel_plan* plan, double row, double column) LOMMEL_NOTHROW;
/* 1 for averages over the area of each pixel, 0 (default) for samples at their middles. */
LOMMEL_API int lommel_plan_integrate(lommel_plan* plan, int integrate) LOMMEL_NOTHROW;
/* Radius of the central obscuration over that of the aperture, from 0 (default) to below 1. */
LOMMEL_API int lommel_plan_obscuration(lommel_plan* plan, double obscuration) LOMMEL_NOTHROW;
/* LOMMEL_ENERGY, LOMMEL_STREHL or LOMMEL_PEAK. */
LOMMEL_API int lommel_plan_normalize(lommel_plan* plan, int normalize) LOMMEL_NOTHROW;
/* Largest number of threads of one call, 1 by default; 0 for the number of processors. */
LOMMEL_API int lommel_plan_threads(lommel_plan* plan, int threads) LOMMEL_NOTHROW;

/* PSFs of `pupils` radially symmetric pupils. coefficients[pupil][term], `terms` of each (1 to 30), are those of the Zernike
 * polynomials R_2^0 = 2 rho^2 - 1, R_4^0 = 6 rho^4 - 6 rho^2 + 1, ..., in radians at the edge of the pupil. A phase
 * 2 C_d rho^2 + C_s rho^4 has the coefficients C_d + C_s / 2 and C_s / 6. C_d > 0: the sensor lies between lens and focus.
 *
 * images[pupil][row][column] receives the values, bounds[pupil], unless it is NULL, a proven bound on the error of each
 * image, relative to the peak of its PSF: at most the tolerance of the plan. lommel_psf_radial_float() writes single
 * precision, whose rounding counts: the tolerance must be above 1e-7 there. */
LOMMEL_API int lommel_psf_radial(const lommel_plan* plan, int32_t pupils, int32_t terms, const double* coefficients,
                                 double* images, double* bounds) LOMMEL_NOTHROW;
LOMMEL_API int lommel_psf_radial_float(const lommel_plan* plan, int32_t pupils, int32_t terms, const double* coefficients,
                                       float* images, double* bounds) LOMMEL_NOTHROW;

/* PSFs of pupils with any aberration: the terms are R_n^|m|(rho) cos(m theta) for m >= 0 and R_n^|m|(rho) sin(|m| theta) for
 * m < 0, with the indices n[term] (at most 200) and m[term], no two alike, and coefficients[pupil][term] in radians at the
 * edge; x grows with the column, y with the row. All else as in lommel_psf_radial(). */
LOMMEL_API int lommel_psf_zernike(const lommel_plan* plan, int32_t pupils, int32_t terms, const int32_t* n, const int32_t* m,
                                  const double* coefficients, double* images, double* bounds) LOMMEL_NOTHROW;
LOMMEL_API int lommel_psf_zernike_float(const lommel_plan* plan, int32_t pupils, int32_t terms, const int32_t* n,
                                        const int32_t* m, const double* coefficients, float* images,
                                        double* bounds) LOMMEL_NOTHROW;

/* Live depth of frames that differ in focus.
 *
 *     lommel_live *live = lommel_live_new(tables, bytes, 480, 640, 1);
 *     float depth[120 * 160], errors[120 * 160], misfit[120 * 160];
 *     const void *frames[] = {near, far};
 *     if (lommel_live_frames(live, frames, 16, 640, depth, errors, misfit) != LOMMEL_OK) {
 *         fprintf(stderr, "%s\n", lommel_message());
 *     }
 *     lommel_live_free(live);
 *
 * `tables` are the bytes of a file that LiveDepth.save() of the Python package has written, which know the lenses, the pixel,
 * the range, the noise and the value of full pixels; they may go afterwards. Frames have height x width pixels, 64 to 16384 a
 * side, and are shared out to so many threads, 1 to 1024; the results do not depend on that. NULL where an argument is out of
 * range, the bytes are no such tables, the frames are smaller than the blur and the filters of the tables, or memory is short.
 * It keeps some rows of each frame for each thread, a value for each block, and for sharp images a few values a pixel.
 *
 * One live serves one thread at a time; any number may be at work at once. */
typedef struct lommel_live lommel_live;
LOMMEL_API lommel_live* lommel_live_new(const void* tables, size_t bytes, int32_t height, int32_t width,
                                        int32_t threads) LOMMEL_NOTHROW;
LOMMEL_API void lommel_live_free(lommel_live* live) LOMMEL_NOTHROW;

/* How many frames belong together, 2 to 16, and the blocks of 4 x 4 pixels that have a depth each: down x across, which are
 * height / 4 and width / 4, rounded down. */
LOMMEL_API int lommel_live_size(const lommel_live* live, int32_t* frames, int32_t* down, int32_t* across) LOMMEL_NOTHROW;

/* Depth of frames[i], in the order of the lenses, of linear grey values of 8 or 16 `bits` a pixel (the latter in the byte order of
 * the machine), rows `stride` pixels apart: depth[down][across] and its standard error, metres, and the misfit, 1 where
 * registration and noise are as stated. Where depth is not known it is NaN and its error infinite; where nothing could be
 * computed, at the border and beside full pixels, the misfit is NaN, too. Exposures are the ratio of the frames' means.
 *
 * LOMMEL_INVALID where a frame is black or full everywhere, or exposures differ by a factor of 2 or more; the next frames may be
 * given all the same. Allocates no memory. */
LOMMEL_API int lommel_live_frames(lommel_live* live, const void* const* frames, int32_t bits, int32_t stride, float* depth,
                                  float* errors, float* misfit) LOMMEL_NOTHROW;

/* The sharp image of the frames of the last call, which must have succeeded and must still be there unchanged:
 * image[height][width], electrons at the exposure of the first frame. The tables must have been made with sharp=True or
 * refocus=True, else LOMMEL_INVALID. Allocates no memory. */
LOMMEL_API int lommel_live_sharp(lommel_live* live, float* image) LOMMEL_NOTHROW;

#ifdef __cplusplus
}
#endif

#endif

#ifndef BITROCK_RUNTIME_H
#define BITROCK_RUNTIME_H
/* Force and torque of the rock on a PDC bit, for whoever simulates what turns it: a C99 interface to bitrock's runtime.
 *
 * The core lies in one block of memory that the caller gives. It takes no memory itself, opens no file, prints nothing,
 * keeps no globals and needs nothing but libm: link libbitrock_runtime.so, or the static library, into an FMU, an
 * S-function or a user subroutine. Two cores know nothing of each other; one core is for one thread at a time.
 *
 *   size_t bytes;                                            // 1. ask how much memory
 *   bitrock_core_size(&description, &bytes);
 *   bitrock_core *core;                                      // 2. make the core in it; the description may go then
 *   bitrock_core_create(malloc(bytes), bytes, &description, &core);
 *   bitrock_core_update(core, angle, rotation, rop, &load);  // 3. at every evaluation, also those a solver rejects
 *   bitrock_core_accept(core, time, rotation, rop);          // 4. if averages are wanted: at the end of every accepted
 *   bitrock_core_averages(core, &rotation, &rop);            //    step; these then go into the updates that follow
 *
 * SI throughout; the only other units are those of the model's inputs, as in a model file.
 *
 * What holds
 * - Force is drawn window by window (theta_T of rotation). A window is drawn once, when it comes into reach, for the
 *   rotation and rate of penetration of that call of `update`; later changes wait for the next window. Events of
 *   BITROCK_MODE_SAWTOOTH are felt from their beginning on, so a window comes into reach when it begins (the first call
 *   draws two: the one before, too); peaks of the other modes reach back, so it does one window before it begins (the
 *   first call draws three). Within drawn windows the load depends on the angle
 *   alone, to the last bit: neither on step size, nor on the order of calls, nor on the rates.
 * - So at constant rates every sequence of angles gives the same bits at the same angle. While rates change, two runs
 *   agree to the last bit as long as each window came into reach at the same rates in both; a run with other steps
 *   enters windows at other moments, hence at slightly other rates, and differs by what the model makes of that.
 * - Going back is free of surprises as far as the window before the one that was reached. Further back, windows that
 *   are no longer kept are drawn anew, with their peaks at the same angles, but for the rates of that call.
 * - A window that a rejected step brought into reach stays as it was drawn. To undo that too, `save` before the step
 *   and `restore` after rejecting it: what follows has the same bits as if the step had not been tried.
 * - The load is twice continuously differentiable in the angle, over the edges of windows too.
 * - A call that returns anything but BITROCK_OK has changed nothing, neither the core nor what its results point to
 *   (BITROCK_BAD_PREDICTION leaves a note for bitrock_core_fault).
 */
#include <stddef.h>
#include <stdint.h>

/* Who compiles the core into a library of his own defines BITROCK_API as nothing, and shows none of it. */
#if defined(BITROCK_API)
#elif defined(_WIN32)
#define BITROCK_API __declspec(dllexport)
#elif defined(__GNUC__)
#define BITROCK_API __attribute__((visibility("default")))
#else
#define BITROCK_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Grows when a function, a structure or the meaning of one changes. */
#define BITROCK_RUNTIME_VERSION 2

/* How a call ended. */
typedef enum {
  BITROCK_OK = 0,                /* done */
  BITROCK_NULL_POINTER = 1,      /* an argument that must point somewhere */
  BITROCK_BAD_MEMORY = 2,        /* too small, or not on an address divisible by 16 */
  BITROCK_NOT_A_CORE = 3,        /* memory that `create` did not fill */
  BITROCK_BAD_SIGNAL = 4,        /* window, pulse width, word or averaging time out of range */
  BITROCK_BAD_CUTTER = 5,        /* no cutter, or a radius or width not above 0, or a rake not finite */
  BITROCK_BAD_MODEL = 6,         /* layers, a scale or a range that cannot be, or a number that is not finite */
  BITROCK_NOT_FINITE = 7,        /* angle, rotation, rate of penetration or time is infinite or not a number */
  BITROCK_ANGLE_TOO_LARGE = 8,   /* beyond 1e15 windows, where they can no longer be told apart */
  BITROCK_BAD_PREDICTION = 9,    /* the model answered with a number that is not finite: see bitrock_core_fault */
  BITROCK_TIME_NOT_LATER = 10,   /* an accepted step must end after the one before */
  BITROCK_NOTHING_ACCEPTED = 11, /* no step yet, so no averages */
  BITROCK_BAD_STATE = 12,        /* bytes that `save` of a core of the same description did not write */
  BITROCK_NO_MOMENTS = 13        /* BITROCK_MODE_SAWTOOTH with a model of ten outputs */
} bitrock_status;

/* One cutter a track: each removes the whole advance of one turn on its own ring. */
typedef struct {
  double radius_m;      /* from the axis to the middle of the ring of rock that it takes, above 0 */
  double width_m;       /* of that ring, above 0; turns force per metre into force */
  double back_rake_rad; /* tilt of the face against the normal of the rock, positive leaning back */
  int64_t number; /* part of the address of its random draws, within 32 bits: different cutters, different numbers */
} bitrock_cutter;

/* Where peaks of a cutter overlap. */
enum {
  BITROCK_COMBINE_SUM = 0, /* they add up */
  BITROCK_COMBINE_MAX = 1  /* the higher counts */
};

/* How the heights of peaks meet their mean. */
enum {
  BITROCK_FIT_BAND_PRESERVING = 0, /* each stays in its band */
  BITROCK_FIT_ARTICLE = 1          /* all are scaled, and may leave their bands */
};

/* What the last layer of a network does with x. */
enum {
  BITROCK_RECTIFIED = 0, /* max(0, x) */
  BITROCK_SOFTPLUS = 1,  /* ln(1 + e^x) */
  BITROCK_LINEAR = 2     /* x */
};

/* What the force is rebuilt from (docs/theory/force_signal.md). */
enum {
  BITROCK_MODE_ARTICLE_LITERAL = 0, /* peaks of five statistics, pulses of one width factor */
  BITROCK_MODE_ARTICLE = 1,         /* the same; pulses so wide that the mean is met, if the model has 17 outputs */
  BITROCK_MODE_SAWTOOTH = 2         /* pulses of mean, standard deviation and correlation lengths; needs 17 outputs */
};

/* How the force is drawn and rebuilt. */
typedef struct {
  double window_angle_rad;   /* theta_T, above 0; pi / 3 is bitrock's default */
  double pulse_width_factor; /* f [1], above 0 and at most 2; 1 is the default */
  int32_t combine;           /* BITROCK_COMBINE_... */
  int32_t amplitude_fit;     /* BITROCK_FIT_... */
  uint64_t seed;             /* of all draws */
  double average_window_s;   /* of `averages`, above 0; 0.1 in the source article */
  int32_t mode;              /* BITROCK_MODE_... */
  int32_t reserved;          /* 0; the structure has no bytes without meaning, so its bytes can be compared */
} bitrock_signal;

/* One input of a network: scaled = (value - offset) / scale, all in the unit of the model file: m/s, mm, deg. */
typedef struct {
  double low, high; /* training range: conditions outside are moved to its edge and counted */
  double offset;    /* taken off before scaling */
  double scale;     /* above 0 */
} bitrock_input;

/* One output and its network: y = offset + scale g for what the network gives, g; or y = y_0 (exp(offset + scale g) -
 * 1) with a log_reference y_0 above 0. Negative y become 0. */
typedef struct {
  double offset, scale;      /* finite; of the logarithm where there is a log_reference */
  double log_reference;      /* y_0, or 0 */
  const double* parameters;  /* for k = 1..K: weights W[k] row by row (n[k] x n[k-1]), then biases b[k] (n[k]) */
  const int32_t* layers;     /* n[0] = 3, n[1], ..., n[K] = 1; each at most 64 */
  int32_t layer_count;       /* K + 1, from 2 to 16 */
  int32_t output_activation; /* BITROCK_RECTIFIED, BITROCK_SOFTPLUS or BITROCK_LINEAR */
} bitrock_output;

/* The networks of one rock: the numbers of a model file. */
typedef struct {
  bitrock_input inputs[3];    /* cutter speed [m/s], depth of cut [mm], back rake [deg] */
  bitrock_output outputs[17]; /* amax [N/m], amean [N/m], np1, np23, np4 [1/m of cut]: five of x (cutting direction),
                                 five of y (axial direction); then, if there are seventeen, mean and standard
                                 deviation of x, of y [N/m], correlation length and short correlation length [m],
                                 correlation of x and y [1] */
  int32_t output_count;       /* 10 or 17 */
} bitrock_model;

/* All that a core is made of. */
typedef struct {
  bitrock_signal signal;         /* how peaks are drawn */
  bitrock_model model;           /* the networks */
  const bitrock_cutter* cutters; /* of the bit */
  int64_t cutter_count;          /* 1 to 1000 */
} bitrock_description;

/* Load of the rock on the bit; resistance to drilling is positive. Rotation and rate of penetration are what you give,
 * force is what you get: the share of cutting alone, F_s and T_s of docs/theory/drillstring.md. What else is between
 * bit and rock is yours to add: the spring of the rock under the bit, whose push W is the weight on bit, friction in
 * proportion to it, and the law by which W and rotation give a rate of penetration. W + F_s is the whole push of the
 * rock. F_s alone is far below a weight on bit and hardly grows with the depth of cut (docs/known_limits.md).
 */
typedef struct {
  double axial_force_N; /* pushes the bit off the rock */
  double torque_N_m;    /* resists its rotation */
} bitrock_load;

/* How often a wish could not be granted since the core was made (or the state was saved that was restored). */
typedef struct {
  int64_t asked; /* questions to the model: one for each cutter and window */
  int64_t speed_below, speed_above, depth_below, depth_above, rake_below, rake_above; /* moved to the training range */
  int64_t drawn;       /* windows with at least one peak, for each cutter and direction; of these: */
  int64_t mean_missed; /* those whose mean peak is not that of the model: its counts and heights do not fit together */
  int64_t band_left;   /* peaks outside their band (BITROCK_FIT_ARTICLE) */
  int64_t narrowed;    /* those with so few peaks that they do not fill the window: widen it */
  int64_t capped;      /* those for which the model asked for more peaks than a window can hold */
  int64_t length_clamped;      /* BITROCK_MODE_SAWTOOTH: those whose correlation lengths the pulses cannot have */
  int64_t correlation_clamped; /* the same: those whose correlation of x and y is out of reach */
} bitrock_tally;

/* A core in memory that the caller gave; only its bytes are known, see bitrock_core_create. */
typedef struct bitrock_core bitrock_core;

/* BITROCK_RUNTIME_VERSION of the library. */
BITROCK_API int32_t bitrock_runtime_version(void);

/* A sentence on a status, in English; never null. */
BITROCK_API const char* bitrock_status_text(bitrock_status status);

/* Checks the description; how much memory its core takes: some 0.1 MB a cutter in BITROCK_MODE_SAWTOOTH,
 * 0.3 MB in the others. */
BITROCK_API bitrock_status bitrock_core_size(const bitrock_description* description, size_t* bytes);

/* Makes a core in `memory`, on an address divisible by 16. Copies all it needs out of the description. A core holds no
 * pointers: its bytes may be moved or copied to other memory, where they are a core too. */
BITROCK_API bitrock_status bitrock_core_create(void* memory, size_t bytes, const bitrock_description* description,
                                               bitrock_core** core);

/* Back to what `create` made. */
BITROCK_API bitrock_status bitrock_core_reset(bitrock_core* core);

/* Load on the bit at an angle it has turned forward while cutting, at this rotation and rate of penetration into the
 * rock. A rotation below 0.0628 rad/s, also a negative one, counts as 0.0628 rad/s when a window is drawn; a rate of
 * penetration of 1e-9 m/s or less, also a negative one, gives windows without peaks. While the rotation changes, see to
 * the angle: one that is wrong by 1 mrad gives another force at the same time (pulses are some mrad wide).
 *
 * At rest and turning back: let the angle grow only while the bit turns forward under weight, never fall. At a held
 * angle the load is frozen at what it was. As it stands it would then turn a resting bit backwards, which no rock does:
 * let it be the most that the torque can be, that of a stiff spring which the turning winds up, cut off at torque_N_m
 * and at 0 (examples/fixed_step.c; the progression angle and the fracture spring of docs/theory/drillstring.md).
 * At steady rates no averages are needed. Where the rates swing, hand in the averages: a window is drawn for the rates
 * of one call. */
BITROCK_API bitrock_status bitrock_core_update(bitrock_core* core, double angle_rad, double rotation_rad_per_s,
                                               double rate_of_penetration_m_per_s, bitrock_load* load);

/* Takes the end of an accepted step into the moving averages of rotation and rate of penetration. Steps may have any
 * length, and it may change. */
BITROCK_API bitrock_status bitrock_core_accept(bitrock_core* core, double time_s, double rotation_rad_per_s,
                                               double rate_of_penetration_m_per_s);

/* Means over the last average_window_s before the last accepted step, weighted by time; at first over what there
 * is. Rates that did not change in that time are their own means, to the last bit. */
BITROCK_API bitrock_status bitrock_core_averages(const bitrock_core* core, double* rotation_rad_per_s,
                                                 double* rate_of_penetration_m_per_s);

/* What was counted so far. */
BITROCK_API bitrock_status bitrock_core_tally(const bitrock_core* core, bitrock_tally* tally);

/* After BITROCK_BAD_PREDICTION: the number of the cutter that was asked about, and which output (0..16) answered so. */
BITROCK_API bitrock_status bitrock_core_fault(const bitrock_core* core, int64_t* cutter_number, int32_t* output);

/* The whole state as bytes: at most 11 kB, and 0.4 kB in use while nothing was accepted. They may be kept, copied and
 * written to a file, and are good for every core of the same description on a machine of the same byte order; a
 * checksum guards them. */
BITROCK_API bitrock_status bitrock_core_state_size(const bitrock_core* core, size_t* bytes);

/* Writes the state to `state`, which has room for `bytes`, at least those of bitrock_core_state_size. */
BITROCK_API bitrock_status bitrock_core_save(const bitrock_core* core, void* state, size_t bytes);

/* Brings a state back; `bytes` as of bitrock_core_save. What follows has the same bits as what followed the save. */
BITROCK_API bitrock_status bitrock_core_restore(bitrock_core* core, const void* state, size_t bytes);

#ifdef __cplusplus
}
#endif

#endif

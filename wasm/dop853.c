/* DOP853 with the coefficients of Hairer, Norsett and Wanner's code (dop853.f, E. Hairer and G. Wanner, University of Geneva), to double
 * precision: all stages share one loop. Orders 8 and 7 are measured in tests/native. */
#include "dop853.h"

/* What the slopes before it contribute to stage 2 … 5, and to stage 6 … 16, where the second and the third contribute nothing. Stage 13 is
 * the end of the step; the three after it belong to the polynomial. */
static const double EARLY[4][4] = {{0.05260015195876773},
                                   {0.0197250569845379, 0.0591751709536137},
                                   {0.02958758547680685, 0, 0.08876275643042054},
                                   {0.2413651341592667, 0, -0.8845494793282861, 0.924834003261792}};
static const double LATE[11][13] = {
    {0.037037037037037035, 0.17082860872947386, 0.12546768756682242},
    {0.037109375, 0.17025221101954405, 0.06021653898045596, -0.017578125},
    {0.03709200011850479, 0.17038392571223998, 0.10726203044637328, -0.015319437748624402, 0.008273789163814023},
    {0.6241109587160757, -3.3608926294469414, -0.868219346841726, 27.59209969944671, 20.154067550477894, -43.48988418106996},
    {0.47766253643826434, -2.4881146199716677, -0.590290826836843, 21.230051448181193, 15.279233632882423, -33.28821096898486,
     -0.020331201708508627},
    {-0.9371424300859873, 5.186372428844064, 1.0914373489967295, -8.149787010746927, -18.52006565999696, 22.739487099350505,
     2.4936055526796523, -3.0467644718982196},
    {2.273310147516538, -10.53449546673725, -2.0008720582248625, -17.9589318631188, 27.94888452941996, -2.8589982771350235,
     -8.87285693353063, 12.360567175794303, 0.6433927460157636},
    {0.054293734116568765, 0, 0, 4.450312892752409, 1.8915178993145003, -5.801203960010585, 0.3111643669578199, -0.1521609496625161,
     0.20136540080403034, 0.04471061572777259},
    {0.056167502283047954, 0, 0, 0, 0.25350021021662483, -0.2462390374708025, -0.12419142326381637, 0.15329179827876568,
     0.00820105229563469, 0.007567897660545699, -0.008298},
    {0.03183464816350214, 0, 0, 0.028300909672366776, 0.053541988307438566, -0.05492374857139099, 0, 0, -0.00010834732869724932,
     0.0003825710908356584, -0.00034046500868740456, 0.1413124436746325},
    {-0.42889630158379194, 0, 0, -4.697621415361164, 7.683421196062599, 4.06898981839711, 0.3567271874552811, 0, 0, 0,
     -0.0013990241651590145, 2.9475147891527724, -9.15095847217987}};

/* The slopes that the step and its embedded results use: the first and the sixth to the twelfth. */
static const double FIFTH[8] = {0.01312004499419488,  -1.2251564463762044, -0.4957589496572502, 1.6643771824549864,
                                -0.35032884874997366, 0.3341791187130175,  0.08192320648511571, -0.022355307863886294};
static const double THIRD[8] = {-0.18980075407240762, 4.450312892752409,   1.8915178993145003,  -5.801203960010585,
                                -0.42268232132379197, -0.1521609496625161, 0.20136540080403034, 0.022651792198360825};

/* The upper four coefficients of the polynomial, from the first slope and the sixth to the sixteenth. Each row adds up to 0, so that what
 * all slopes have in common can be left out: these large numbers would make 1e-12 of its rounding. */
static const double DENSE[4][12] = {
    {-8.428938276109013, 0.5667149535193777, -3.0689499459498917, 2.38466765651207, 2.117034582445028, -0.871391583777973,
     2.2404374302607883, 0.6315787787694688, -0.08899033645133331, 18.148505520854727, -9.194632392478356, -4.436036387594894},
    {10.427508642579134, 242.28349177525817, 165.20045171727028, -374.5467547226902, -22.113666853125306, 7.733432668472264,
     -30.674084731089398, -9.332130526430229, 15.697238121770845, -31.139403219565178, -9.35292435884448, 35.81684148639408},
    {19.985053242002433, -387.0373087493518, -189.17813819516758, 527.8081592054236, -11.57390253995963, 6.8812326946963,
     -1.0006050966910838, 0.7777137798053443, -2.778205752353508, -60.19669523126412, 84.32040550667716, 11.99229113618279},
    {-25.69393346270375, -154.18974869023643, -231.5293791760455, 357.6391179106141, 93.40532418362432, -37.45832313645163,
     104.0996495089623, 29.8402934266605, -43.53345659001114, 96.32455395918828, -39.17726167561544, -149.72683625798564}};

enum { STEP = 12 };

/* The sum of slopes, weighted: the first, and after `skipped` others the next. Inlined, it would save a tenth of a
 * trace's time and take half a kilobyte. */
__attribute__((noinline)) static void combine(const struct sp_stages *stages, const double *weights, int count, int skipped, double *sum) {
    for (int i = 0; i < SP_STATE; i++)
        sum[i] = weights[0] * stages->slope[0][i];
    for (int j = 1; j < count; j++)
        for (int i = 0; i < SP_STATE; i++)
            sum[i] += weights[j] * stages->slope[j + skipped][i];
}

/* The state at stage number `stage`, counted from 0. */
static void stage_state(const double *state, double h, const struct sp_stages *stages, int stage, double *at) {
    double sum[SP_STATE];
    int skipped = stage < 5 ? 0 : 2;
    combine(stages, skipped ? LATE[stage - 5] : EARLY[stage - 1], stage - skipped, skipped, sum);
    for (int i = 0; i < SP_STATE; i++)
        at[i] = state[i] + h * sum[i];
}

static void evaluate_stages(const struct sp_ode *ode, const double *state, double h, struct sp_stages *stages, int first, int end) {
    double at[SP_STATE];
    for (int stage = first; stage < end; stage++) {
        stage_state(state, h, stages, stage, at);
        ode->slope(ode->context, at, stages->slope[stage]);
    }
}

void sp_dop853_step(const struct sp_ode *ode, const double *state, double h, struct sp_stages *stages, double *next) {
    evaluate_stages(ode, state, h, stages, 1, STEP);
    stage_state(state, h, stages, STEP, next);
}

void sp_dop853_errors(const struct sp_stages *stages, double *fifth, double *third) {
    combine(stages, FIFTH, 8, 4, fifth);
    combine(stages, THIRD, 8, 4, third);
}

void sp_dop853_dense(const struct sp_ode *ode, const double *state, double h, struct sp_stages *stages, const double *next,
                     struct sp_dense *dense) {
    double(*slope)[SP_STATE] = stages->slope;
    ode->slope(ode->context, next, slope[STEP]);
    evaluate_stages(ode, state, h, stages, STEP + 1, SP_STAGES);
    for (int i = 0; i < SP_STATE; i++) {
        double change = next[i] - state[i], first = slope[0][i], bend = h * first - change;
        dense->coefficients[0][i] = state[i], dense->coefficients[1][i] = change, dense->coefficients[2][i] = bend;
        dense->coefficients[3][i] = change - h * slope[STEP][i] - bend;
        for (int j = 0; j < SP_STAGES; j++)
            slope[j][i] = h * (slope[j][i] - first);
    }
    for (int k = 0; k < 4; k++)
        combine(stages, DENSE[k], 12, 4, dense->coefficients[4 + k]);
}

void sp_dop853_between(const struct sp_dense *dense, double fraction, double *state) {
    double factors[2] = {fraction, 1 - fraction};
    for (int i = 0; i < SP_STATE; i++) {
        double sum = dense->coefficients[7][i];
        for (int k = 6; k >= 0; k--)
            sum = dense->coefficients[k][i] + factors[k & 1] * sum;
        state[i] = sum;
    }
}

/* Elementary functions of arrays: included once for every width.

   Generated from templates/c/elementary_functions.h.j2, the same for every scene, with
   Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`. */

/* Sine and cosine of an angle, each within one unit in the last place. Taylor's series of the angle modulo a quarter of a turn. 97 operations: 20 additions, 29 subtractions, 29 multiplications, 5 negations, 1 absolute value, 5 comparisons, 2 disjunctions, 6 selections. */
static void WIDE(sine_cosine)(size_t count, const double *restrict angle_of, double *restrict sine_to, double *restrict cosine_to)
{
    for (size_t i = 0; i < count; i++) {
        const double angle = angle_of[i];
        const _Bool _s0 = 1048576.0 < fabs(angle);
        const double _s1 = (6755399441055744.0 + (0.6366197723675814 * angle)) - 6755399441055744.0;
        const double _s2 = _s1 - (4.0 * ((6755399441055744.0 + ((0.25 * _s1) - 0.375)) - 6755399441055744.0));
        const _Bool _s3 = _s2 == 1.0;
        const _Bool _s4 = _s3 | (_s2 == 3.0);
        const double _s5 = angle - (1.570796325802803 * _s1);
        const double _s6 = 9.920935791635221e-10 * _s1;
        const double _s7 = _s5 - _s6;
        const double _s8 = 5.17018297889025e-19 * _s1;
        const double _s9 = _s7 - _s8;
        const double _s10 = _s7 - _s5;
        const double _s11 = _s9 - _s7;
        const double _s12 = (((_s5 - (_s7 - _s10)) + (-(_s10 + _s6))) + ((_s7 - (_s9 - _s11)) + (-(_s11 + _s8)))) - (2.9038559739793605e-28 * _s1);
        const double _s13 = _s9 + _s12;
        const double _s14 = _s13 * _s13;
        const double _s15 = 0.5 * _s14;
        const double _s16 = 1.0 - _s15;
        const double _s17 = (((4.779477332387385e-14 + (-(1.5619206968586225e-16 * _s14))) * _s14) - 1.1470745597729725e-11) * _s14;
        const double _s18 = (2.48015873015873e-05 + ((((2.08767569878681e-09 + _s17) * _s14) - 2.755731922398589e-07) * _s14)) * _s14;
        const double _s19 = _s13 - _s9;
        const double _s20 = (_s9 - (_s13 - _s19)) + (_s12 - _s19);
        const double _s21 = (((0.041666666666666664 + ((_s18 - 0.001388888888888889) * _s14)) * (_s14 * _s14)) - (_s13 * _s20)) + ((1.0 - _s16) - _s15);
        const double _s22 = _s16 + _s21;
        const double _s23 = ((1.6059043836821613e-10 + (((2.8114572543455206e-15 * _s14) - 7.647163731819816e-13) * _s14)) * _s14) - 2.505210838544172e-08;
        const double _s24 = 0.008333333333333333 + ((((2.7557319223985893e-06 + (_s23 * _s14)) * _s14) - 0.0001984126984126984) * _s14);
        const double _s25 = (((_s13 * _s14) * ((_s24 * _s14) - 0.16666666666666666)) + (_s16 * _s20)) + _s13;
        const double _s26 = _s4 ? _s22 : _s25;
        const double _s27 = _s4 ? _s25 : _s22;
        sine_to[i] = _s0 ? (INFINITY) : ((_s2 < 2.0) ? _s26 : (-_s26));
        cosine_to[i] = _s0 ? (INFINITY) : ((_s3 | (_s2 == 2.0)) ? (-_s27) : _s27);
    }
}

/* Tangent of an angle, within four units in the last place. sine over cosine. 98 operations: 20 additions, 29 subtractions, 29 multiplications, 1 division, 5 negations, 1 absolute value, 5 comparisons, 2 disjunctions, 6 selections. */
static void WIDE(tangent)(size_t count, const double *restrict angle_of, double *restrict tangent_to)
{
    for (size_t i = 0; i < count; i++) {
        const double angle = angle_of[i];
        const _Bool _s0 = 1048576.0 < fabs(angle);
        const double _s1 = (6755399441055744.0 + (0.6366197723675814 * angle)) - 6755399441055744.0;
        const double _s2 = _s1 - (4.0 * ((6755399441055744.0 + ((0.25 * _s1) - 0.375)) - 6755399441055744.0));
        const _Bool _s3 = _s2 == 1.0;
        const _Bool _s4 = _s3 | (_s2 == 3.0);
        const double _s5 = angle - (1.570796325802803 * _s1);
        const double _s6 = 9.920935791635221e-10 * _s1;
        const double _s7 = _s5 - _s6;
        const double _s8 = 5.17018297889025e-19 * _s1;
        const double _s9 = _s7 - _s8;
        const double _s10 = _s7 - _s5;
        const double _s11 = _s9 - _s7;
        const double _s12 = (((_s5 - (_s7 - _s10)) + (-(_s10 + _s6))) + ((_s7 - (_s9 - _s11)) + (-(_s11 + _s8)))) - (2.9038559739793605e-28 * _s1);
        const double _s13 = _s9 + _s12;
        const double _s14 = _s13 * _s13;
        const double _s15 = 0.5 * _s14;
        const double _s16 = 1.0 - _s15;
        const double _s17 = (((4.779477332387385e-14 + (-(1.5619206968586225e-16 * _s14))) * _s14) - 1.1470745597729725e-11) * _s14;
        const double _s18 = (2.48015873015873e-05 + ((((2.08767569878681e-09 + _s17) * _s14) - 2.755731922398589e-07) * _s14)) * _s14;
        const double _s19 = _s13 - _s9;
        const double _s20 = (_s9 - (_s13 - _s19)) + (_s12 - _s19);
        const double _s21 = (((0.041666666666666664 + ((_s18 - 0.001388888888888889) * _s14)) * (_s14 * _s14)) - (_s13 * _s20)) + ((1.0 - _s16) - _s15);
        const double _s22 = _s16 + _s21;
        const double _s23 = ((1.6059043836821613e-10 + (((2.8114572543455206e-15 * _s14) - 7.647163731819816e-13) * _s14)) * _s14) - 2.505210838544172e-08;
        const double _s24 = 0.008333333333333333 + ((((2.7557319223985893e-06 + (_s23 * _s14)) * _s14) - 0.0001984126984126984) * _s14);
        const double _s25 = (((_s13 * _s14) * ((_s24 * _s14) - 0.16666666666666666)) + (_s16 * _s20)) + _s13;
        const double _s26 = _s4 ? _s22 : _s25;
        const double _s27 = _s4 ? _s25 : _s22;
        tangent_to[i] = (_s0 ? (INFINITY) : ((_s2 < 2.0) ? _s26 : (-_s26))) / (_s0 ? (INFINITY) : ((_s3 | (_s2 == 2.0)) ? (-_s27) : _s27));
    }
}

/* Angle of a point from the axis of abscissas, within two units in the last place. atan(a) + atan(b) = atan((a + b)/(1 - ab)); Taylor's series. 69 operations: 11 additions, 12 subtractions, 19 multiplications, 1 division, 2 negations, 2 absolute values, 8 comparisons, 14 selections. */
static void WIDE(arc_tangent)(size_t count, const double *restrict ordinate_of, const double *restrict abscissa_of, double *restrict angle_to)
{
    for (size_t i = 0; i < count; i++) {
        const double ordinate = ordinate_of[i];
        const double abscissa = abscissa_of[i];
        const double _s0 = fabs(abscissa);
        const double _s1 = fabs(ordinate);
        const double _s2 = _s0 < _s1 ? _s0 : _s1;
        const double _s3 = _s0 < _s1 ? _s1 : _s0;
        const _Bool _s4 = (4.0 * _s2) <= _s3;
        const _Bool _s5 = (0.75 * _s3) < _s2;
        const double _s6 = _s4 ? _s3 : (_s5 ? (_s3 + _s2) : (_s3 + (0.5 * _s2)));
        const double _s7 = (_s6 <= 0.0) ? 0.0 : ((_s4 ? _s2 : (_s5 ? (_s2 - _s3) : (_s2 - (0.5 * _s3)))) / _s6);
        const double _s8 = _s7 * _s7;
        const double _s9 = (((0.04 + (-(0.037037037037037035 * _s8))) * _s8) - 0.043478260869565216) * _s8;
        const double _s10 = (0.058823529411764705 + ((((0.047619047619047616 + _s9) * _s8) - 0.05263157894736842) * _s8)) * _s8;
        const double _s11 = (((0.07692307692307693 + ((_s10 - 0.06666666666666667) * _s8)) * _s8) - 0.09090909090909091) * _s8;
        const double _s12 = (0.2 + ((((0.1111111111111111 + _s11) * _s8) - 0.14285714285714285) * _s8)) * _s8;
        const double _s13 = ((((_s8 * _s7) * (_s12 - 0.3333333333333333)) + (_s4 ? 0.0 : (_s5 ? 3.061616997868383e-17 : 8.553660459218291e-16))) + _s7) + (_s4 ? 0.0 : (_s5 ? 0.7853981633974483 : 0.46364760900080526));
        const double _s14 = (_s0 < _s1) ? (1.5707963267948966 - (_s13 - 6.123233995736766e-17)) : _s13;
        const double _s15 = (abscissa < 0.0) ? (3.141592653589793 - (_s14 - 1.2246467991473532e-16)) : _s14;
        angle_to[i] = (ordinate < 0.0) ? (-_s15) : _s15;
    }
}

/* Distance of a point from the origin, within one unit in the last place. Pythagoras, and a step of Newton's method. 53 operations: 12 additions, 18 subtractions, 19 multiplications, 1 division, 1 square root, 1 comparison, 1 selection. */
static void WIDE(hypotenuse)(size_t count, const double *restrict ordinate_of, const double *restrict abscissa_of, double *restrict distance_to)
{
    for (size_t i = 0; i < count; i++) {
        const double ordinate = ordinate_of[i];
        const double abscissa = abscissa_of[i];
        const double _s0 = ordinate * ordinate;
        const double _s1 = abscissa * abscissa;
        const double _s2 = _s0 + _s1;
        const double _s3 = sqrt(_s2);
        const double _s4 = _s3 * _s3;
        const double _s5 = 134217729.0 * _s3;
        const double _s6 = _s5 - (_s5 - _s3);
        const double _s7 = _s3 - _s6;
        const double _s8 = _s2 - _s1;
        const double _s9 = 134217729.0 * ordinate;
        const double _s10 = _s9 - (_s9 - ordinate);
        const double _s11 = ordinate - _s10;
        const double _s12 = 134217729.0 * abscissa;
        const double _s13 = _s12 - (_s12 - abscissa);
        const double _s14 = abscissa - _s13;
        const double _s15 = ((_s0 - _s8) + (_s1 - (_s2 - _s8))) + (((((_s10 * _s10) - _s0) + (2.0 * (_s11 * _s10))) + (_s11 * _s11)) + ((((_s13 * _s13) - _s1) + (2.0 * (_s14 * _s13))) + (_s14 * _s14)));
        const double _s16 = ((_s2 - _s4) - ((((_s6 * _s6) - _s4) + (2.0 * (_s7 * _s6))) + (_s7 * _s7))) + _s15;
        distance_to[i] = (0.0 < _s3) ? ((_s16 / (2.0 * _s3)) + _s3) : _s3;
    }
}

/* Standard normal number below which is a probability in the middle. Algorithm AS 241. 33 operations: 14 additions, 2 subtractions, 16 multiplications, 1 division. */
static void WIDE(normal_middle)(size_t count, const double *restrict probability_of, double *restrict quantile_to)
{
    for (size_t i = 0; i < count; i++) {
        const double probability = probability_of[i];
        const double _s0 = probability - 0.5;
        const double _s1 = 0.180625 - (_s0 * _s0);
        const double _s2 = 21213.794301586597 + (_s1 * (39307.89580009271 + (_s1 * (28729.085735721943 + (5226.495278852854 * _s1)))));
        const double _s3 = 42.31333070160091 + (_s1 * (687.1870074920579 + (_s1 * (5394.196021424751 + (_s1 * _s2)))));
        const double _s4 = 45921.95393154987 + (_s1 * (67265.7709270087 + (_s1 * (33430.57558358813 + (2509.0809287301227 * _s1)))));
        const double _s5 = 133.14166789178438 + (_s1 * (1971.5909503065513 + (_s1 * (13731.69376550946 + (_s1 * _s4)))));
        quantile_to[i] = ((3.3871328727963665 + (_s1 * _s5)) / (1.0 + (_s1 * _s3))) * _s0;
    }
}

/* Standard normal number below which is a probability in one of the tails. Algorithm AS 241. 136 operations: 46 additions, 7 subtractions, 51 multiplications, 3 divisions, 1 square root, 1 negation, 10 comparisons, 17 selections. */
static void WIDE(normal_tail)(size_t count, const double *restrict probability_of, double *restrict quantile_to)
{
    for (size_t i = 0; i < count; i++) {
        const double probability = probability_of[i];
        const double _s0 = 1.0 - probability;
        const double _s1 = _s0 < probability ? _s0 : probability;
        const _Bool _s2 = _s1 < 2.3283064365386963e-10;
        const double _s3 = _s1 * (_s2 ? 4294967296.0 : 1.0);
        const _Bool _s4 = _s3 < 1.52587890625e-05;
        const double _s5 = _s3 * (_s4 ? 65536.0 : 1.0);
        const _Bool _s6 = _s5 < 0.00390625;
        const double _s7 = _s5 * (_s6 ? 256.0 : 1.0);
        const _Bool _s8 = _s7 < 0.0625;
        const double _s9 = _s7 * (_s8 ? 16.0 : 1.0);
        const _Bool _s10 = _s9 < 0.25;
        const double _s11 = _s9 * (_s10 ? 4.0 : 1.0);
        const _Bool _s12 = _s11 < 0.5;
        const double _s13 = (((((_s2 ? 32.0 : 0.0) + (_s4 ? 16.0 : 0.0)) + (_s6 ? 8.0 : 0.0)) + (_s8 ? 4.0 : 0.0)) + (_s10 ? 2.0 : 0.0)) + (_s12 ? 1.0 : 0.0);
        const double _s14 = _s11 * (_s12 ? 2.0 : 1.0);
        const _Bool _s15 = _s14 < 0.70703125;
        const double _s16 = _s13 + (_s15 ? 1.0 : 0.0);
        const double _s17 = _s14 * (_s15 ? 2.0 : 1.0);
        const double _s18 = (_s17 - 1.0) / (1.0 + _s17);
        const double _s19 = _s18 * _s18;
        const double _s20 = 0.11764705882352941 + ((0.10526315789473684 + ((0.09523809523809523 + (0.08695652173913043 * _s19)) * _s19)) * _s19);
        const double _s21 = 0.18181818181818182 + ((0.15384615384615385 + ((0.13333333333333333 + (_s20 * _s19)) * _s19)) * _s19);
        const double _s22 = 0.4 + ((0.2857142857142857 + ((0.2222222222222222 + (_s21 * _s19)) * _s19)) * _s19);
        const double _s23 = (((1.9082149292705877e-10 * _s16) - ((_s18 * _s19) * (0.6666666666666666 + (_s22 * _s19)))) - (2.0 * _s18)) + (0.6931471803691238 * _s16);
        const double _s24 = sqrt(_s23);
        const double _s25 = _s24 - 1.6;
        const double _s26 = 0.14810397642748008 + (_s25 * (0.015198666563616457 + (_s25 * (0.0005475938084995345 + (1.0507500716444169e-09 * _s25)))));
        const double _s27 = 2.053191626637759 + (_s25 * (1.6763848301838038 + (_s25 * (0.6897673349851 + (_s25 * _s26)))));
        const double _s28 = 1.2704582524523684 + (_s25 * (0.2417807251774506 + (_s25 * (0.022723844989269184 + (0.0007745450142783414 * _s25)))));
        const double _s29 = 4.630337846156546 + (_s25 * (5.769497221460691 + (_s25 * (3.6478483247632045 + (_s25 * _s28)))));
        const double _s30 = _s24 - 5.0;
        const double _s31 = 0.0007868691311456133 + (_s30 * (1.8463183175100548e-05 + (_s30 * (1.421511758316446e-07 + (2.0442631033899397e-15 * _s30)))));
        const double _s32 = 0.599832206555888 + (_s30 * (0.1369298809227358 + (_s30 * (0.014875361290850615 + (_s30 * _s31)))));
        const double _s33 = 0.026532189526576124 + (_s30 * (0.0012426609473880784 + (_s30 * (2.7115555687434876e-05 + (2.0103343992922881e-07 * _s30)))));
        const double _s34 = 5.463784911164114 + (_s30 * (1.7848265399172913 + (_s30 * (0.29656057182850487 + (_s30 * _s33)))));
        const double _s35 = (_s24 <= 5.0) ? ((1.4234371107496835 + (_s25 * _s29)) / (1.0 + (_s25 * _s27))) : ((6.657904643501103 + (_s30 * _s34)) / (1.0 + (_s30 * _s32)));
        quantile_to[i] = ((probability - 0.5) < 0.0) ? (-_s35) : _s35;
    }
}

/* Direction from the ring's centre opposite to which the ball is sent. h = azimuth + angle. 1 operation: 1 addition. */
static void WIDE(release_heading)(size_t count, const double *restrict azimuth_of, const double *restrict angle_of, double *restrict heading_to)
{
    for (size_t i = 0; i < count; i++) {
        const double azimuth = azimuth_of[i];
        const double angle = angle_of[i];
        heading_to[i] = azimuth + angle;
    }
}

/* State of a release, given the sine and the cosine of its angles. ahead = -(cos h, sin h). 12 operations: 1 subtraction, 8 multiplications, 3 negations. */
static void WIDE(release_state)(size_t count, const double *restrict speed_of, const double *restrict backspin_of, const double *restrict sidespin_of, const double *restrict height_of, const double *restrict distance_of, const double *restrict ring_height_of, const double *restrict sin_heading_of, const double *restrict cos_heading_of, const double *restrict sin_elevation_of, const double *restrict cos_elevation_of, const double *restrict sin_angle_of, const double *restrict cos_angle_of, double *restrict x_to, double *restrict y_to, double *restrict z_to, double *restrict vx_to, double *restrict vy_to, double *restrict vz_to, double *restrict wx_to, double *restrict wy_to, double *restrict wz_to)
{
    for (size_t i = 0; i < count; i++) {
        const double speed = speed_of[i];
        const double backspin = backspin_of[i];
        const double sidespin = sidespin_of[i];
        const double height = height_of[i];
        const double distance = distance_of[i];
        const double ring_height = ring_height_of[i];
        const double sin_heading = sin_heading_of[i];
        const double cos_heading = cos_heading_of[i];
        const double sin_elevation = sin_elevation_of[i];
        const double cos_elevation = cos_elevation_of[i];
        const double sin_angle = sin_angle_of[i];
        const double cos_angle = cos_angle_of[i];
        const double _s0 = -cos_heading;
        const double _s1 = speed * cos_elevation;
        const double _s2 = -sin_heading;
        x_to[i] = distance * cos_angle;
        y_to[i] = distance * sin_angle;
        z_to[i] = height - ring_height;
        vx_to[i] = _s0 * _s1;
        vy_to[i] = _s2 * _s1;
        vz_to[i] = speed * sin_elevation;
        wx_to[i] = backspin * _s2;
        wy_to[i] = -(backspin * _s0);
        wz_to[i] = sidespin;
    }
}

/* True if a probability is in the middle. */
static inline _Bool WIDE(normal_is_middle)(double probability)
{
    return fabs((probability - 0.5)) <= 0.425;
}

/* Standard normal numbers below which are probabilities: first as if all were in the middle, then the tails anew,
   packed and in whole vectors. */
static void WIDE(normal_quantile)(size_t count, const double *restrict probability_of, double *restrict quantile_to)
{
    size_t places[TILE];
    double packed[TILE], tails[TILE];
    for (size_t first = 0; first < count; first += TILE) {
        const size_t end = count - first < TILE ? count : first + TILE;
        size_t found = 0, whole;
        WIDE(normal_middle)(end - first, probability_of + first, quantile_to + first);
        for (size_t i = first; i < end; i++) {
            places[found] = i;
            found += !WIDE(normal_is_middle)(probability_of[i]);
        }
        for (size_t k = 0; k < found; k++)
            packed[k] = probability_of[places[k]];
        for (whole = found; whole % WIDTH; whole++)
            packed[whole] = packed[0];
        WIDE(normal_tail)(whole, packed, tails);
        for (size_t k = 0; k < found; k++)
            quantile_to[places[k]] = tails[k];
    }
}

APART static void WIDE(compute)(int function, size_t count, const double *const *arguments, double *const *results)
{
    switch (function) {
    case 0:
        WIDE(sine_cosine)(count, arguments[0], results[0], results[1]);
        break;
    case 1:
        WIDE(tangent)(count, arguments[0], results[0]);
        break;
    case 2:
        WIDE(arc_tangent)(count, arguments[0], arguments[1], results[0]);
        break;
    case 3:
        WIDE(hypotenuse)(count, arguments[0], arguments[1], results[0]);
        break;
    case 4:
        WIDE(normal_quantile)(count, arguments[0], results[0]);
        break;
    }
}

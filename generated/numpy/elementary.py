"""Elementary functions in IEEE operations alone, the same bits on every processor.

Generated from templates/numpy/elementary.py.j2, the same for every scene, with
Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`.
Every function takes scalars or arrays that broadcast and is evaluated element by element.
"""

# ruff: noqa: E501

from __future__ import annotations

from typing import Any

from numpy import absolute as _absolute
from numpy import inf as _inf
from numpy import logical_or as _logical_or
from numpy import sqrt as _sqrt
from numpy import where as _where

FUNCTIONS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "sine_cosine": (("angle",), ("sine", "cosine",)),
    "tangent": (("angle",), ("tangent",)),
    "arc_tangent": (("ordinate", "abscissa",), ("angle",)),
    "hypotenuse": (("ordinate", "abscissa",), ("distance",)),
    "normal_quantile": (("probability",), ("quantile",)),
}
"""The functions in the order of the C library: the names of arguments and of results."""

DERIVATION = "3e98ff40d8b3edb7"
"""A hash of all that the functions compute: with another one the same seed has other releases."""


def sine_cosine(angle: Any) -> tuple[Any, ...]:
    """Sine and cosine of an angle, each within one unit in the last place.

    Taylor's series of the angle modulo a quarter of a turn. 97 operations: 20 additions, 29 subtractions, 29 multiplications, 5 negations, 1 absolute value, 5 comparisons, 2 disjunctions, 6 selections.
    """
    _s0 = 1048576.0 < _absolute(angle)
    _s1 = (6755399441055744.0 + (0.6366197723675814 * angle)) - 6755399441055744.0
    _s2 = _s1 - (4.0 * ((6755399441055744.0 + ((0.25 * _s1) - 0.375)) - 6755399441055744.0))
    _s3 = _s2 == 1.0
    _s4 = _logical_or(_s3, (_s2 == 3.0))
    _s5 = angle - (1.570796325802803 * _s1)
    _s6 = 9.920935791635221e-10 * _s1
    _s7 = _s5 - _s6
    _s8 = 5.17018297889025e-19 * _s1
    _s9 = _s7 - _s8
    _s10 = _s7 - _s5
    _s11 = _s9 - _s7
    _s12 = (((_s5 - (_s7 - _s10)) + (-(_s10 + _s6))) + ((_s7 - (_s9 - _s11)) + (-(_s11 + _s8)))) - (2.9038559739793605e-28 * _s1)
    _s13 = _s9 + _s12
    _s14 = _s13 * _s13
    _s15 = 0.5 * _s14
    _s16 = 1.0 - _s15
    _s17 = (((4.779477332387385e-14 + (-(1.5619206968586225e-16 * _s14))) * _s14) - 1.1470745597729725e-11) * _s14
    _s18 = (2.48015873015873e-05 + ((((2.08767569878681e-09 + _s17) * _s14) - 2.755731922398589e-07) * _s14)) * _s14
    _s19 = _s13 - _s9
    _s20 = (_s9 - (_s13 - _s19)) + (_s12 - _s19)
    _s21 = (((0.041666666666666664 + ((_s18 - 0.001388888888888889) * _s14)) * (_s14 * _s14)) - (_s13 * _s20)) + ((1.0 - _s16) - _s15)
    _s22 = _s16 + _s21
    _s23 = ((1.6059043836821613e-10 + (((2.8114572543455206e-15 * _s14) - 7.647163731819816e-13) * _s14)) * _s14) - 2.505210838544172e-08
    _s24 = 0.008333333333333333 + ((((2.7557319223985893e-06 + (_s23 * _s14)) * _s14) - 0.0001984126984126984) * _s14)
    _s25 = (((_s13 * _s14) * ((_s24 * _s14) - 0.16666666666666666)) + (_s16 * _s20)) + _s13
    _s26 = _where(_s4, _s22, _s25)
    _s27 = _where(_s4, _s25, _s22)
    return (_where(_s0, _inf, _where((_s2 < 2.0), _s26, (-_s26))), _where(_s0, _inf, _where(_logical_or(_s3, (_s2 == 2.0)), (-_s27), _s27)),)


def tangent(angle: Any) -> tuple[Any, ...]:
    """Tangent of an angle, within four units in the last place.

    sine over cosine. 98 operations: 20 additions, 29 subtractions, 29 multiplications, 1 division, 5 negations, 1 absolute value, 5 comparisons, 2 disjunctions, 6 selections.
    """
    _s0 = 1048576.0 < _absolute(angle)
    _s1 = (6755399441055744.0 + (0.6366197723675814 * angle)) - 6755399441055744.0
    _s2 = _s1 - (4.0 * ((6755399441055744.0 + ((0.25 * _s1) - 0.375)) - 6755399441055744.0))
    _s3 = _s2 == 1.0
    _s4 = _logical_or(_s3, (_s2 == 3.0))
    _s5 = angle - (1.570796325802803 * _s1)
    _s6 = 9.920935791635221e-10 * _s1
    _s7 = _s5 - _s6
    _s8 = 5.17018297889025e-19 * _s1
    _s9 = _s7 - _s8
    _s10 = _s7 - _s5
    _s11 = _s9 - _s7
    _s12 = (((_s5 - (_s7 - _s10)) + (-(_s10 + _s6))) + ((_s7 - (_s9 - _s11)) + (-(_s11 + _s8)))) - (2.9038559739793605e-28 * _s1)
    _s13 = _s9 + _s12
    _s14 = _s13 * _s13
    _s15 = 0.5 * _s14
    _s16 = 1.0 - _s15
    _s17 = (((4.779477332387385e-14 + (-(1.5619206968586225e-16 * _s14))) * _s14) - 1.1470745597729725e-11) * _s14
    _s18 = (2.48015873015873e-05 + ((((2.08767569878681e-09 + _s17) * _s14) - 2.755731922398589e-07) * _s14)) * _s14
    _s19 = _s13 - _s9
    _s20 = (_s9 - (_s13 - _s19)) + (_s12 - _s19)
    _s21 = (((0.041666666666666664 + ((_s18 - 0.001388888888888889) * _s14)) * (_s14 * _s14)) - (_s13 * _s20)) + ((1.0 - _s16) - _s15)
    _s22 = _s16 + _s21
    _s23 = ((1.6059043836821613e-10 + (((2.8114572543455206e-15 * _s14) - 7.647163731819816e-13) * _s14)) * _s14) - 2.505210838544172e-08
    _s24 = 0.008333333333333333 + ((((2.7557319223985893e-06 + (_s23 * _s14)) * _s14) - 0.0001984126984126984) * _s14)
    _s25 = (((_s13 * _s14) * ((_s24 * _s14) - 0.16666666666666666)) + (_s16 * _s20)) + _s13
    _s26 = _where(_s4, _s22, _s25)
    _s27 = _where(_s4, _s25, _s22)
    return (_where(_s0, _inf, _where((_s2 < 2.0), _s26, (-_s26))) / _where(_s0, _inf, _where(_logical_or(_s3, (_s2 == 2.0)), (-_s27), _s27)),)


def arc_tangent(ordinate: Any, abscissa: Any) -> tuple[Any, ...]:
    """Angle of a point from the axis of abscissas, within two units in the last place.

    atan(a) + atan(b) = atan((a + b)/(1 - ab)); Taylor's series. 69 operations: 11 additions, 12 subtractions, 19 multiplications, 1 division, 2 negations, 2 absolute values, 8 comparisons, 14 selections.
    """
    _s0 = _absolute(abscissa)
    _s1 = _absolute(ordinate)
    _s2 = _where(_s0 < _s1, _s0, _s1)
    _s3 = _where(_s0 < _s1, _s1, _s0)
    _s4 = (4.0 * _s2) <= _s3
    _s5 = (0.75 * _s3) < _s2
    _s6 = _where(_s4, _s3, _where(_s5, (_s3 + _s2), (_s3 + (0.5 * _s2))))
    _s7 = _where((_s6 <= 0.0), 0.0, (_where(_s4, _s2, _where(_s5, (_s2 - _s3), (_s2 - (0.5 * _s3)))) / _s6))
    _s8 = _s7 * _s7
    _s9 = (((0.04 + (-(0.037037037037037035 * _s8))) * _s8) - 0.043478260869565216) * _s8
    _s10 = (0.058823529411764705 + ((((0.047619047619047616 + _s9) * _s8) - 0.05263157894736842) * _s8)) * _s8
    _s11 = (((0.07692307692307693 + ((_s10 - 0.06666666666666667) * _s8)) * _s8) - 0.09090909090909091) * _s8
    _s12 = (0.2 + ((((0.1111111111111111 + _s11) * _s8) - 0.14285714285714285) * _s8)) * _s8
    _s13 = ((((_s8 * _s7) * (_s12 - 0.3333333333333333)) + _where(_s4, 0.0, _where(_s5, 3.061616997868383e-17, 8.553660459218291e-16))) + _s7) + _where(_s4, 0.0, _where(_s5, 0.7853981633974483, 0.46364760900080526))
    _s14 = _where((_s0 < _s1), (1.5707963267948966 - (_s13 - 6.123233995736766e-17)), _s13)
    _s15 = _where((abscissa < 0.0), (3.141592653589793 - (_s14 - 1.2246467991473532e-16)), _s14)
    return (_where((ordinate < 0.0), (-_s15), _s15),)


def hypotenuse(ordinate: Any, abscissa: Any) -> tuple[Any, ...]:
    """Distance of a point from the origin, within one unit in the last place.

    Pythagoras, and a step of Newton's method. 53 operations: 12 additions, 18 subtractions, 19 multiplications, 1 division, 1 square root, 1 comparison, 1 selection.
    """
    _s0 = ordinate * ordinate
    _s1 = abscissa * abscissa
    _s2 = _s0 + _s1
    _s3 = _sqrt(_s2)
    _s4 = _s3 * _s3
    _s5 = 134217729.0 * _s3
    _s6 = _s5 - (_s5 - _s3)
    _s7 = _s3 - _s6
    _s8 = _s2 - _s1
    _s9 = 134217729.0 * ordinate
    _s10 = _s9 - (_s9 - ordinate)
    _s11 = ordinate - _s10
    _s12 = 134217729.0 * abscissa
    _s13 = _s12 - (_s12 - abscissa)
    _s14 = abscissa - _s13
    _s15 = ((_s0 - _s8) + (_s1 - (_s2 - _s8))) + (((((_s10 * _s10) - _s0) + (2.0 * (_s11 * _s10))) + (_s11 * _s11)) + ((((_s13 * _s13) - _s1) + (2.0 * (_s14 * _s13))) + (_s14 * _s14)))
    _s16 = ((_s2 - _s4) - ((((_s6 * _s6) - _s4) + (2.0 * (_s7 * _s6))) + (_s7 * _s7))) + _s15
    return (_where((0.0 < _s3), ((_s16 / (2.0 * _s3)) + _s3), _s3),)


def normal_quantile(probability: Any) -> tuple[Any, ...]:
    """Standard normal number below which is a probability, within six units in the last place.

    Algorithm AS 241. 171 operations: 60 additions, 8 subtractions, 67 multiplications, 4 divisions, 1 square root, 1 negation, 1 absolute value, 11 comparisons, 18 selections.
    """
    _s0 = probability - 0.5
    _s1 = 0.180625 - (_s0 * _s0)
    _s2 = 21213.794301586597 + (_s1 * (39307.89580009271 + (_s1 * (28729.085735721943 + (5226.495278852854 * _s1)))))
    _s3 = 42.31333070160091 + (_s1 * (687.1870074920579 + (_s1 * (5394.196021424751 + (_s1 * _s2)))))
    _s4 = 45921.95393154987 + (_s1 * (67265.7709270087 + (_s1 * (33430.57558358813 + (2509.0809287301227 * _s1)))))
    _s5 = 133.14166789178438 + (_s1 * (1971.5909503065513 + (_s1 * (13731.69376550946 + (_s1 * _s4)))))
    _s6 = 1.0 - probability
    _s7 = _where(_s6 < probability, _s6, probability)
    _s8 = _s7 < 2.3283064365386963e-10
    _s9 = _s7 * _where(_s8, 4294967296.0, 1.0)
    _s10 = _s9 < 1.52587890625e-05
    _s11 = _s9 * _where(_s10, 65536.0, 1.0)
    _s12 = _s11 < 0.00390625
    _s13 = _s11 * _where(_s12, 256.0, 1.0)
    _s14 = _s13 < 0.0625
    _s15 = _s13 * _where(_s14, 16.0, 1.0)
    _s16 = _s15 < 0.25
    _s17 = _s15 * _where(_s16, 4.0, 1.0)
    _s18 = _s17 < 0.5
    _s19 = ((((_where(_s8, 32.0, 0.0) + _where(_s10, 16.0, 0.0)) + _where(_s12, 8.0, 0.0)) + _where(_s14, 4.0, 0.0)) + _where(_s16, 2.0, 0.0)) + _where(_s18, 1.0, 0.0)
    _s20 = _s17 * _where(_s18, 2.0, 1.0)
    _s21 = _s20 < 0.70703125
    _s22 = _s19 + _where(_s21, 1.0, 0.0)
    _s23 = _s20 * _where(_s21, 2.0, 1.0)
    _s24 = (_s23 - 1.0) / (1.0 + _s23)
    _s25 = _s24 * _s24
    _s26 = 0.11764705882352941 + ((0.10526315789473684 + ((0.09523809523809523 + (0.08695652173913043 * _s25)) * _s25)) * _s25)
    _s27 = 0.18181818181818182 + ((0.15384615384615385 + ((0.13333333333333333 + (_s26 * _s25)) * _s25)) * _s25)
    _s28 = 0.4 + ((0.2857142857142857 + ((0.2222222222222222 + (_s27 * _s25)) * _s25)) * _s25)
    _s29 = (((1.9082149292705877e-10 * _s22) - ((_s24 * _s25) * (0.6666666666666666 + (_s28 * _s25)))) - (2.0 * _s24)) + (0.6931471803691238 * _s22)
    _s30 = _sqrt(_s29)
    _s31 = _s30 - 1.6
    _s32 = 0.14810397642748008 + (_s31 * (0.015198666563616457 + (_s31 * (0.0005475938084995345 + (1.0507500716444169e-09 * _s31)))))
    _s33 = 2.053191626637759 + (_s31 * (1.6763848301838038 + (_s31 * (0.6897673349851 + (_s31 * _s32)))))
    _s34 = 1.2704582524523684 + (_s31 * (0.2417807251774506 + (_s31 * (0.022723844989269184 + (0.0007745450142783414 * _s31)))))
    _s35 = 4.630337846156546 + (_s31 * (5.769497221460691 + (_s31 * (3.6478483247632045 + (_s31 * _s34)))))
    _s36 = _s30 - 5.0
    _s37 = 0.0007868691311456133 + (_s36 * (1.8463183175100548e-05 + (_s36 * (1.421511758316446e-07 + (2.0442631033899397e-15 * _s36)))))
    _s38 = 0.599832206555888 + (_s36 * (0.1369298809227358 + (_s36 * (0.014875361290850615 + (_s36 * _s37)))))
    _s39 = 0.026532189526576124 + (_s36 * (0.0012426609473880784 + (_s36 * (2.7115555687434876e-05 + (2.0103343992922881e-07 * _s36)))))
    _s40 = 5.463784911164114 + (_s36 * (1.7848265399172913 + (_s36 * (0.29656057182850487 + (_s36 * _s39)))))
    _s41 = _where((_s30 <= 5.0), ((1.4234371107496835 + (_s31 * _s35)) / (1.0 + (_s31 * _s33))), ((6.657904643501103 + (_s36 * _s40)) / (1.0 + (_s36 * _s38))))
    return (_where((_absolute(_s0) <= 0.425), (((3.3871328727963665 + (_s1 * _s5)) / (1.0 + (_s1 * _s3))) * _s0), _where((_s0 < 0.0), (-_s41), _s41)),)

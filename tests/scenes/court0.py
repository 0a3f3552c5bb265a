from __future__ import annotations
from dataclasses import replace
import sympy as sp
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import Box, Ring, body
p = {q.name: q.symbol for q in HOOP.parameters}
th = parameter("board_thickness","m","thickness",0.03); bd=parameter("bridge_depth","m","depth",0.12)
law = HOOP.bodies[0].law
rb=p["ball_radius"]
board=Box("backboard",(-p["board_distance"]-th.symbol,-p["board_half_width"],p["board_bottom"]),(-p["board_distance"],p["board_half_width"],p["board_top"]),rb)
bridge=Box("bridge",(-p["board_distance"],-p["bridge_half_width"],p["wire_radius"]-bd.symbol),(-p["ring_radius"],p["bridge_half_width"],p["wire_radius"]),rb)
COURT0=replace(HOOP,name="court0",parameters=(*HOOP.parameters,th,bd),bodies=(HOOP.bodies[0],body(board,law),body(bridge,law)),rolls=True)

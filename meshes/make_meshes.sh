#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
#
# Makes every mesh of this folder again; needs gmsh (4.8) and python3.
set -eu
cd "$(dirname "$0")"

make_mesh() # FORMAT NAME.msh NAME.geo [-setnumber VARIABLE VALUE]...
{
  format=$1 mesh=$2 geometry=$3
  shift 3
  gmsh -2 -v 2 -format "$format" "$@" -o "$mesh" "$geometry"
}

make_mesh msh41 s0.msh s0.geo
make_mesh msh22 s0_split.msh s0.geo -setnumber split 1
make_mesh msh41 s0_tri.msh s0.geo -setnumber triangles 1
make_mesh msh41 raous_32.msh raous.geo -setnumber n 32
make_mesh msh41 raous_64.msh raous.geo -setnumber n 64
make_mesh msh41 patch_quad.msh patch.geo -setnumber size 0.8
make_mesh msh41 patch_tri.msh patch.geo -setnumber triangles 1
gmsh -3 -v 2 -format msh41 -o patch_hex.msh patch_3d.geo
gmsh -3 -v 2 -format msh41 -setnumber tetrahedra 1 -o patch_tet.msh patch_3d.geo
gmsh -3 -v 2 -format msh41 -o dam_block_3d.msh dam_block_3d.geo
gmsh -3 -v 2 -format msh41 -o arch_dam.msh arch_dam.geo
gmsh -3 -v 2 -format msh41 -setnumber tetrahedra 1 -o arch_dam_tet.msh arch_dam.geo
make_mesh msh41 crack.msh crack.geo
make_mesh msh41 cross.msh cross.geo
make_mesh msh41 wall.msh wall.geo
make_mesh msh41 dam.msh dam.geo
make_mesh msh41 high_dam.msh high_dam.geo
make_mesh msh41 footing.msh footing.geo
make_mesh msh41 arch.msh arch.geo
make_mesh msh41 pier.msh pier.geo
make_mesh msh41 anchor.msh anchor.geo
make_mesh msh41 hertz.msh hertz.geo
make_mesh msh41 punch.msh punch.geo
make_mesh msh41 retaining_wall.msh retaining_wall.geo
for n in 9 33 129; do
  python3 scene_g.py "$n" "scene_g_$n.msh"
done

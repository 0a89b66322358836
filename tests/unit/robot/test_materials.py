from __future__ import annotations

import sdfcheck

SDF = (
    '<sdf version="1.9"><model name="m"><link name="l"><visual name="v"><geometry><box/></geometry>'
    "<material><ambient>0.1 0.2 0.3</ambient><diffuse>1 0 0 0.5</diffuse><specular>1 0</specular></material>"
    "</visual></link></model></sdf>"
)


def test_an_alpha_that_is_left_out_is_one() -> None:
    (visual,) = sdfcheck.parse(SDF).models[0].link("l").visuals
    material = visual.material
    ambient = material.light("ambient")
    assert ambient is not None
    assert ambient.text == "0.1 0.2 0.3"
    assert ambient == (0.1, 0.2, 0.3, 1.0)
    assert material.color == (1.0, 0.0, 0.0, 0.5)
    assert material.light("specular") == (1.0, 0.0)
    assert material.light("emissive") is None

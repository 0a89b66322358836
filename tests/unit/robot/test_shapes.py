from __future__ import annotations

import sdfcheck


def test_what_is_before_the_shape_in_sdf_is_not_the_shape() -> None:
    text = (
        '<sdf version="1.9" xmlns:x="urn:x"><model name="m"><link name="l">'
        '<visual name="a"><geometry><x:y/><box><size>1 2 3</size></box></geometry></visual>'
        '<visual name="b"><geometry><x:y/></geometry></visual>'
        '<visual name="c"><geometry/></visual></link></model></sdf>'
    )
    first, second, third = (each.geometry for each in sdfcheck.parse(text).models[0].link("l").visuals)
    assert (first.shape, first.size) == ("box", (1, 2, 3))
    assert second.shape == "x:y"
    assert third.shape == ""


def test_urdfdom_takes_the_first_element_for_the_shape() -> None:
    text = (
        '<robot name="r" xmlns:x="urn:x"><link name="l"><visual><geometry><x:y/><box size="1 2 3"/></geometry>'
        "</visual></link></robot>"
    )
    (visual,) = sdfcheck.parse(text).models[0].link("l").visuals
    assert visual.geometry.shape == "x:y"

"""The table and the documents of the examples."""

TABLE = {
    "acme.vendor.txt": """vendor\tAcme\thttps://example.org/acme
reads\tsdf\tlenient
reads\turdf\tstrict
unknown\tsdf\terror
unknown\turdf\tignored

armature\tdouble\t0\trange=[0,inf]
 sdf\tmodel/joint/axis/dynamics\ttext\t0
 urdf\trobot/joint/dynamics\tattribute\t0
gripper
 sdf\tmodel\t\t*
 @name\tstring\t1\t\tunique=error
finger\tname\t\tref=link
 sdf\tmodel/:gripper\ttext\t+
grip\tword\t\tchoices=soft,hard\tbad=error\texcludes=:force
 sdf\tmodel/:gripper\ttext\t0
force\tdouble
 sdf\tmodel/:gripper\ttext\t0
bumper\tflag
 sdf\tmodel\t\t0
buffer\tflag\t\tgone=:bumper\twrong=ignored
"""
}
HEAD = '<sdf version="1.12" xmlns:acme="https://example.org/acme"><model name="m">'
MODEL = f'{HEAD}<link name="a"/><link name="b"/>{{}}</model></sdf>'
JOINT = MODEL.replace(
    "{}",
    '<joint name="j" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz>'
    "<dynamics>{}</dynamics></axis></joint>",
)
ROBOT = (
    '<robot name="r" xmlns:acme="https://example.org/acme"><link name="a"/><link name="b"/>'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/>{}</joint></robot>'
)
GRIPPER = '<acme:gripper name="g"><acme:finger>a</acme:finger>{}</acme:gripper>'

# What errands share: a window (../window.sh), and a count of what a hand did. Source it with the script's own arguments.
errands=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
source "$errands/../window.sh"
begin=$SECONDS
clicks=0

# A named widget is clicked.
hit() {
    clicks=$((clicks + 1))
    click "$1"
}
# A number is typed into a parameter.
enter() {
    clicks=$((clicks + 1))
    type_into "$1" "$2"
}
# A place of the picture is clicked.
press() {
    clicks=$((clicks + 1))
    press_at "$1" "$2"
}
# A file's name is typed into the dialog that asks for one.
name_file() {
    await_widget "file name"
    frames 2
    xdotool key ctrl+a type --delay 1 "$1"
    xdotool key Return
    await_work
}
# A picture of the window, once it is at rest.
shot() {
    xdotool mousemove 640 12
    frames 600
    import -window root "$1.png"
}
is_there() { [ -s "$1" ] || fail "there is no $1"; }

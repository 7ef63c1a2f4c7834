//! Families of mechanisms with known results: rounded files, independent mechanisms in one file, loops drawn open,
//! extreme sizes.

mod drawn_open;
mod first_poses;
mod gazebo_joints;
mod independent_groups;
mod rigid;
mod rounded_files;
mod tiny_and_huge;
mod turned_lines;

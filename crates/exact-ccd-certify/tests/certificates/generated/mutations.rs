//! Certificates with changes: each accepted statement is true, by the exact kernel on all pairs.

use exact_ccd_check::bytes::Bytes;
use exact_ccd_check::certificate::{FREE, Head, MAGIC, REST, stretches};
use exact_ccd_mesh::Contact;

use super::{Random, are_true, kind, scene};
use crate::proof::{Scene, certify, verify};

/// Scenes that are free at first, with their certificates, which have a property, distances and
/// earliest contacts.
fn certified(count: usize, has: impl Fn(&[u8]) -> bool) -> Vec<(Scene, Vec<u8>, f64, Contact)> {
    let mut random = Random(2);
    let mut all = Vec::new();
    while all.len() < count {
        let (is_lattice, d) = (all.len() % 4 == 3, [0.0, 0.0625][all.len() % 2]);
        let scene = scene(&mut random, is_lattice, false);
        let contact = scene
            .earliest(d)
            .filter(|contact| !contact.impact.touching_at_start());
        if let (Some(contact), Ok(certificate)) = (contact, certify(&scene, d))
            && has(&certificate)
        {
            all.push((scene, certificate, d, contact));
        }
    }
    all
}

const DISTANCE: usize = MAGIC.len();
const FLAGS: usize = DISTANCE + 8;
const TIMES: usize = FLAGS + 1;

/// Checks 10,000 mutations of one kind: an accepted certificate must be true. Returns the numbers of changed
/// certificates, and of changed certificates that are accepted.
fn mutate(seed: u64, mutate: impl Fn(&mut Random, &mut Vec<u8>, f64, &Contact)) -> [usize; 2] {
    mutate_some(seed, 50, |_| true, mutate)
}

/// The same, of so many certificates with a property.
fn mutate_some(
    seed: u64,
    count: usize,
    has: impl Fn(&[u8]) -> bool,
    mutate: impl Fn(&mut Random, &mut Vec<u8>, f64, &Contact),
) -> [usize; 2] {
    let mut random = Random(seed);
    let scenes = certified(count, has);
    let (mut differ, mut accepted) = (0, 0);
    for round in 0..10_000 {
        let (scene, certificate, d, contact) = &scenes[round % scenes.len()];
        let mut bytes = certificate.clone();
        mutate(&mut random, &mut bytes, *d, contact);
        differ += usize::from(bytes != *certificate);
        if let Ok(proved) = verify(scene, &bytes) {
            accepted += usize::from(bytes != *certificate);
            assert!(are_true(scene, &proved), "round {round}: {proved}");
        }
    }
    [differ, accepted]
}

#[test]
fn a_later_time_is_refused() {
    let [differ, _] = mutate(3, |random, bytes, _, contact| {
        let upper = contact.impact.time.upper();
        let later = upper + random.real() * random.real() * (1.0 - upper);
        if bytes[FLAGS] & FREE != 0 {
            bytes[FLAGS] = bytes[FLAGS] & REST | FREE;
            bytes[TIMES..TIMES + 8].copy_from_slice(&later.to_le_bytes());
            // The time of contact.
            bytes.drain(TIMES + 8..TIMES + 16);
        }
    });
    assert!(differ > 3000);
}

#[test]
fn a_larger_distance_is_refused() {
    let [differ, _] = mutate(4, |random, bytes, d, _| {
        let larger = d + 4.0 * random.real() * random.real() * random.real();
        bytes[DISTANCE..DISTANCE + 8].copy_from_slice(&larger.to_le_bytes());
    });
    assert!(differ > 9000);
}

#[test]
fn changed_bytes_prove_nothing_false() {
    // Pairs, directions, ends of stretches, tags, counts, weights: any byte after the times.
    let [differ, _] = mutate(5, |random, bytes, _, _| {
        let place = TIMES + random.below((bytes.len() - TIMES) as u64) as usize;
        bytes[place] ^= 1 << random.below(8);
    });
    assert_eq!(differ, 10_000);
    let [differ, _] = mutate(6, |random, bytes, _, _| {
        let place = TIMES + random.below((bytes.len() - TIMES) as u64) as usize;
        bytes[place] = bytes[place].wrapping_neg();
    });
    assert!(differ > 5000);
}

/// A row of a table, by the places of four bytes: the number of rows, the row's begin, its first tag, its
/// end.
struct Row {
    count: usize,
    begin: usize,
    tag: usize,
    end: usize,
    is_last: bool,
}

fn rows(certificate: &[u8]) -> Vec<Row> {
    tables(certificate).0
}

/// The place of the proof of contact.
fn contact(certificate: &[u8]) -> usize {
    tables(certificate).1
}

/// The rows of all tables, and the place behind the last one.
fn tables(certificate: &[u8]) -> (Vec<Row>, usize) {
    let mut bytes = Bytes(&certificate[FLAGS..]);
    let place = |bytes: &Bytes<'_>| certificate.len() - bytes.0.len();
    let head = Head::read(&mut bytes).unwrap();
    let mut rows = Vec::new();
    for table in 0..4 + usize::from(head.rest) {
        let until = if head.rest && table == 0 {
            0.0
        } else {
            head.free.unwrap()
        };
        let count = place(&bytes);
        let total = bytes.number().unwrap();
        for number in 1..=total {
            let begin = place(&bytes);
            bytes.number().and_then(|_| bytes.number()).unwrap();
            let tag = place(&bytes);
            stretches(&mut bytes, until).unwrap();
            rows.push(Row {
                count,
                begin,
                tag,
                end: place(&bytes),
                is_last: number == total,
            });
        }
    }
    let end = place(&bytes);
    (rows, end)
}

/// A random row that has a property, if one is found.
fn any(random: &mut Random, certificate: &[u8], has: impl Fn(&Row) -> bool) -> Option<Row> {
    let mut rows: Vec<Row> = rows(certificate).into_iter().filter(has).collect();
    (!rows.is_empty()).then(|| rows.swap_remove(random.below(rows.len() as u64) as usize))
}

#[test]
fn a_reversed_direction_is_refused() {
    let [differ, accepted] = mutate(11, |random, bytes, _, _| {
        let certificate = bytes.clone();
        if let Some(row) = any(random, bytes, |row| certificate[row.tag] == 0) {
            bytes[row.tag + 1..row.tag + 4]
                .iter_mut()
                .for_each(|byte| *byte = byte.wrapping_neg());
        }
    });
    assert!(differ > 9000 && accepted == 0);
}

#[test]
fn a_dropped_pair_is_refused() {
    let [differ, accepted] = mutate(12, |random, bytes, _, _| {
        if let Some(row) = any(random, bytes, |row| row.is_last) {
            bytes[row.count] -= 1;
            bytes.drain(row.begin..row.end);
        }
    });
    assert!(differ > 9000 && accepted == 0);
}

/// Returns true if a pair of a certificate has several stretches.
fn has_stretches(certificate: &[u8]) -> bool {
    rows(certificate).iter().any(|row| certificate[row.tag] & 1 != 0)
}

#[test]
fn a_dropped_stretch_proves_nothing_false() {
    // Rows of several stretches: without the first, or with the first alone, up to T.
    let [differ, accepted] = mutate_some(13, 25, has_stretches, |random, bytes, _, _| {
        let certificate = bytes.clone();
        if let Some(row) = any(random, bytes, |row| certificate[row.tag] & 1 != 0) {
            let tag = certificate[row.tag];
            let components = if tag & 2 == 0 { 3 } else { 6 } << (tag >> 2);
            let first = row.tag + 9..row.tag + 9 + components;
            if random.below(2) == 0 {
                bytes.drain(row.tag..first.end);
            } else {
                let alone = [&[tag - 1], &certificate[first]].concat();
                bytes.splice(row.tag..row.end, alone);
            }
        }
    });
    assert_eq!(differ, 10_000);
    assert!(accepted < 9_000);
}

#[test]
fn a_dropped_part_is_refused() {
    let [differ, _] = mutate(7, |random, bytes, _, _| {
        let begin = TIMES + random.below((bytes.len() - TIMES) as u64) as usize;
        let end = bytes.len().min(begin + 1 + random.below(12) as usize);
        bytes.drain(begin..end);
    });
    assert_eq!(differ, 10_000);
}

#[test]
fn another_pair_in_contact_is_refused_unless_it_is() {
    // The proof of contact is the last part; its kind and indices are changed together.
    let [differ, _] = mutate(8, |random, bytes, _, contact| {
        let ids = contact.pair.ids();
        let key = [kind(contact.pair) as u8, ids[0] as u8, ids[1] as u8];
        if let Some(place) = bytes.windows(3).rposition(|window| window == key) {
            bytes[place + 1 + random.below(2) as usize] = random.below(14) as u8;
        }
    });
    assert!(differ > 3000);
}

/// The parts of a certificate of one step that a change may concern.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Field {
    Distance,
    Flags,
    Free,
    Contact,
    Count,
    Ids,
    Tag,
    End,
    Direction,
    Kind,
    ContactIds,
    Proof,
}

const FIELDS: [Field; 12] = [
    Field::Distance,
    Field::Flags,
    Field::Free,
    Field::Contact,
    Field::Count,
    Field::Ids,
    Field::Tag,
    Field::End,
    Field::Direction,
    Field::Kind,
    Field::ContactIds,
    Field::Proof,
];

/// All fields of a certificate, with their places, which cover all bytes behind the first line.
fn fields(certificate: &[u8]) -> Vec<(Field, std::ops::Range<usize>)> {
    let mut fields = vec![
        (Field::Distance, DISTANCE..FLAGS),
        (Field::Flags, FLAGS..TIMES),
        (Field::Free, TIMES..TIMES + 8),
        (Field::Contact, TIMES + 8..TIMES + 16),
    ];
    let mut begin = TIMES + 16;
    for row in rows(certificate) {
        if row.count >= begin {
            // Tables without rows have a number of rows, too.
            fields.extend((begin..row.count).map(|place| (Field::Count, place..place + 1)));
            fields.push((Field::Count, row.count..row.begin));
        }
        fields.push((Field::Ids, row.begin..row.tag));
        let mut place = row.tag;
        while place < row.end {
            let tag = certificate[place];
            fields.push((Field::Tag, place..place + 1));
            place += 1;
            if tag & 1 != 0 {
                fields.push((Field::End, place..place + 8));
                place += 8;
            }
            let size = if tag & 2 == 0 { 3 } else { 6 } << (tag >> 2);
            fields.push((Field::Direction, place..place + size));
            place += size;
        }
        begin = row.end;
    }
    let contact = contact(certificate);
    fields.extend((begin..contact).map(|place| (Field::Count, place..place + 1)));
    fields.push((Field::Kind, contact..contact + 1));
    // Of fewer than 128 primitives, an id has one byte.
    fields.push((Field::ContactIds, contact + 1..contact + 3));
    fields.push((Field::Proof, contact + 3..certificate.len()));
    let covered: usize = fields.iter().map(|(_, place)| place.len()).sum();
    assert_eq!(covered, certificate.len() - DISTANCE);
    fields
}

#[test]
fn no_change_of_a_field_proves_anything_false() {
    println!("{:?}", change_fields(500));
}

#[test]
#[ignore = "takes minutes: cargo test -p exact-ccd-certify --test certificates -- --ignored"]
fn none_of_10_000_changes_of_a_field_proves_anything_false() {
    println!("{:?}", change_fields(10_000));
}

/// Changes each field `count` times, to other bytes: nothing false is accepted. Another number of rows, other
/// ids of a row and another T⁺ are never accepted. Returns for each field the number of accepted changes,
/// which are all true.
fn change_fields(count: usize) -> [(Field, usize); 12] {
    // Some with pairs of several stretches.
    let mut scenes = certified(50, |certificate| certificate[FLAGS] & FREE != 0);
    scenes.extend(certified(5, has_stretches));
    let mut random = Random(14);
    FIELDS.map(|field| {
        let places: Vec<(usize, std::ops::Range<usize>)> = scenes
            .iter()
            .enumerate()
            .flat_map(|(scene, (_, certificate, ..))| {
                let fields = fields(certificate).into_iter();
                let of_field = fields.filter(move |(other, _)| *other == field);
                of_field.map(move |(_, place)| (scene, place))
            })
            .collect();
        assert!(places.len() > 4, "{field:?}");
        let (mut changed, mut accepted) = (0, 0);
        while changed < count {
            let (scene, place) = places[random.below(places.len() as u64) as usize].clone();
            let (scene, certificate, ..) = &scenes[scene];
            let mut bytes = certificate.clone();
            change(&mut random, field, &mut bytes[place]);
            if bytes == *certificate {
                continue;
            }
            changed += 1;
            if let Ok(proved) = verify(scene, &bytes) {
                accepted += 1;
                assert!(are_true(scene, &proved), "{field:?}: {proved}");
            }
        }
        let is_structure = matches!(field, Field::Count | Field::Ids | Field::Contact);
        assert!(!is_structure || accepted == 0, "{field:?}");
        (field, accepted)
    })
}

/// Other bytes: for numbers, near ones too.
fn change(random: &mut Random, field: Field, bytes: &mut [u8]) {
    let is_number = matches!(field, Field::Distance | Field::Free | Field::Contact | Field::End);
    if is_number && random.below(2) == 0 {
        let mut number = [0; 8];
        number.copy_from_slice(bytes);
        let x = f64::from_le_bytes(number);
        let x = match random.below(4) {
            0 => x.next_up(),
            1 => x.next_down(),
            2 => random.real(),
            _ => x + 1e-6 * random.real(),
        };
        bytes.copy_from_slice(&x.to_le_bytes());
        return;
    }
    let place = random.below(bytes.len() as u64) as usize;
    bytes[place] = match random.below(3) {
        0 => bytes[place].wrapping_add(1),
        1 => bytes[place].wrapping_sub(1),
        _ => random.below(256) as u8,
    };
}

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>StructureKind</name>
    <message>
        <source>Parenchyma</source>
        <translation>Parenchym</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Hepatic vein</source>
        <translation>Lebervene</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Hohlvene</translation>
    </message>
    <message>
        <source>Artery</source>
        <translation>Arterie</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>Cyst</source>
        <translation>Zyste</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>Bile duct</source>
        <translation>Gallengang</translation>
    </message>
    <message>
        <source>Not part of the liver model</source>
        <translation>Nicht Teil des Lebermodells</translation>
    </message>
</context>
<context>
    <name>glisson::CaseOpener</name>
    <message>
        <source>The labels will be moved onto the CT&apos;s grid (nearest voxel). Borders may shift by half a voxel.</source>
        <translation>Die Labels werden auf das Gitter der CT gelegt (nächstes Voxel). Grenzen können sich um ein halbes Voxel verschieben.</translation>
    </message>
    <message>
        <source>The CT was taken with a tilted gantry. It will be straightened by resampling; fine detail is softened.</source>
        <translation>Die CT wurde mit gekippter Gantry aufgenommen. Sie wird durch Umrechnen begradigt; feine Einzelheiten werden weicher.</translation>
    </message>
    <message>
        <source>Slices are missing or unevenly spaced. The gaps will be filled by resampling: what lies in them is unseen.</source>
        <translation>Schichten fehlen oder liegen ungleich weit auseinander. Die Lücken werden durch Umrechnen gefüllt: Was darin liegt, bleibt ungesehen.</translation>
    </message>
    <message>
        <source>CT and labels name different patients or studies. If they do not belong together, every number is wrong.</source>
        <translation>CT und Labels nennen verschiedene Patienten oder Studien. Gehören sie nicht zusammen, ist jede Zahl falsch.</translation>
    </message>
    <message>
        <source>Making the sample patient</source>
        <translation>Beispielpatient entsteht</translation>
    </message>
    <message>
        <source>Reading files</source>
        <translation>Dateien werden gelesen</translation>
    </message>
    <message>
        <source>%1 has the label %2 of unknown kind; name it with --labels.</source>
        <translation>%1 hat das Label %2 unbekannter Art; benennen Sie es mit --labels.</translation>
    </message>
    <message>
        <source>A question before reading</source>
        <translation>Eine Frage vor dem Lesen</translation>
    </message>
    <message>
        <source>Read it all the same</source>
        <translation>Trotzdem lesen</translation>
    </message>
    <message>
        <source>The file places its voxels in two ways that disagree (sform and qform). The wrong one moves or mirrors the liver. Choose the one your other programs use.</source>
        <translation>Die Datei beschreibt die Lage ihrer Voxel auf zwei Arten, die sich widersprechen (sform und qform). Die falsche verschiebt oder spiegelt die Leber. Wählen Sie die, welche Ihre anderen Programme verwenden.</translation>
    </message>
    <message>
        <source>Use sform</source>
        <translation>sform verwenden</translation>
    </message>
    <message>
        <source>Use qform</source>
        <translation>qform verwenden</translation>
    </message>
</context>
<context>
    <name>glisson::CasePanel</name>
    <message>
        <source>Open files...</source>
        <translation>Dateien öffnen...</translation>
    </message>
    <message>
        <source>A CT with its segmentation, or a case (Ctrl+O)</source>
        <translation>Eine CT mit ihrer Segmentierung oder ein Fall (Strg+O)</translation>
    </message>
    <message>
        <source>Which label is what</source>
        <translation>Welches Label was ist</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>CT: %1</source>
        <translation>CT: %1</translation>
    </message>
    <message>
        <source>No CT is shown.</source>
        <translation>Es wird keine CT gezeigt.</translation>
    </message>
    <message>
        <source>Labels: %1</source>
        <translation>Labels: %1</translation>
    </message>
    <message>
        <source>Grid: %1 x %2 x %3 voxels of %4 x %5 x %6 mm</source>
        <translation>Gitter: %1 x %2 x %3 Voxel zu %4 x %5 x %6 mm</translation>
    </message>
    <message>
        <source>Nothing is loaded.</source>
        <translation>Nichts geladen.</translation>
    </message>
    <message>
        <source>%1 deviates: %2</source>
        <translation>%1 weicht ab: %2</translation>
    </message>
    <message>
        <source>Problems and notes: %1</source>
        <translation>Probleme und Hinweise: %1</translation>
    </message>
</context>
<context>
    <name>glisson::Document</name>
    <message>
        <source>place plane</source>
        <translation>Ebene setzen</translation>
    </message>
    <message>
        <source>move plane</source>
        <translation>Ebene bewegen</translation>
    </message>
    <message>
        <source>remove plane</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>change colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>change opacity</source>
        <translation>Deckkraft ändern</translation>
    </message>
    <message>
        <source>The CT at %1 does not lie on the grid of the labels and is not shown.</source>
        <translation>Die CT unter %1 liegt nicht auf dem Gitter der Labels und wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volumina</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Abstände</translation>
    </message>
</context>
<context>
    <name>glisson::ExportPanel</name>
    <message>
        <source>Export package...</source>
        <translation>Paket exportieren...</translation>
    </message>
    <message>
        <source>A folder for navigation: the structures, the remnant, the resected part and the resection surface, with plan.json and a manifest. Every file is read back and compared before it counts as exported. Millimetres, LPS.</source>
        <translation>Ein Ordner für die Navigation: die Strukturen, der Rest, der Resektatteil und die Resektionsfläche, mit plan.json und einem Verzeichnis. Jede Datei wird zurückgelesen und verglichen, bevor sie als exportiert gilt. Millimeter, LPS.</translation>
    </message>
    <message>
        <source>STL, one file per structure</source>
        <translation>STL, eine Datei je Struktur</translation>
    </message>
    <message>
        <source>GLB, one file with colours</source>
        <translation>GLB, eine Datei mit Farben</translation>
    </message>
    <message>
        <source>Write the patient&apos;s id into plan.json</source>
        <translation>Patienten-ID in plan.json schreiben</translation>
    </message>
    <message>
        <source>Otherwise nothing in the package names the patient.</source>
        <translation>Sonst nennt nichts im Paket den Patienten.</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>%1 has no surface yet.</source>
        <translation>%1 hat noch keine Oberfläche.</translation>
    </message>
    <message>
        <source>Choose a format.</source>
        <translation>Wählen Sie ein Format.</translation>
    </message>
    <message>
        <source>Writes the navigation package (Ctrl+E)</source>
        <translation>Schreibt das Navigationspaket (Strg+E)</translation>
    </message>
    <message>
        <source>These structures deviate from their voxels; you will be asked before they are exported:</source>
        <translation>Diese Strukturen weichen von ihren Voxeln ab; vor dem Export werden Sie gefragt:</translation>
    </message>
    <message>
        <source>Exported and verified: %1</source>
        <translation>Exportiert und geprüft: %1</translation>
    </message>
    <message>
        <source>Folder for the package</source>
        <translation>Ordner für das Paket</translation>
    </message>
    <message>
        <source>Structures deviate</source>
        <translation>Strukturen weichen ab</translation>
    </message>
    <message>
        <source>The surfaces of these structures differ from their voxels more than they should. A navigation system would show them as they are.</source>
        <translation>Die Oberflächen dieser Strukturen weichen stärker von ihren Voxeln ab, als sie sollten. Ein Navigationssystem würde sie so zeigen.</translation>
    </message>
    <message>
        <source>Export all the same</source>
        <translation>Trotzdem exportieren</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Out of date, exported before the last change: %1</source>
        <translation>Veraltet, vor der letzten Änderung exportiert: %1</translation>
    </message>
    <message>
        <source>not exported</source>
        <translation>nicht exportiert</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>exported</source>
        <translation>exportiert</translation>
    </message>
</context>
<context>
    <name>glisson::JobBar</name>
    <message>
        <source>Cancel all</source>
        <translation>Alle abbrechen</translation>
    </message>
    <message>
        <source>3D: left turns, middle pans, right zooms</source>
        <translation>3D: links dreht, Mitte schiebt, rechts zoomt</translation>
    </message>
    <message>
        <source>Slices: wheel steps, left click places the crosshair, right zooms, middle pans, Ctrl+right changes the window</source>
        <translation>Schichten: Rad blättert, Linksklick setzt das Fadenkreuz, rechts zoomt, Mitte schiebt, Strg+rechts ändert das Fenster</translation>
    </message>
    <message>
        <source>Not for clinical use</source>
        <translation>Nicht zur klinischen Anwendung</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 warten</translation>
    </message>
</context>
<context>
    <name>glisson::JobRunner</name>
    <message>
        <source>The work ended with an unknown error.</source>
        <translation>Die Arbeit endete mit einem unbekannten Fehler.</translation>
    </message>
    <message>
        <source>There is not enough memory for this; close other programs and try again.</source>
        <translation>Dafür reicht der Speicher nicht; schließen Sie andere Programme und versuchen Sie es erneut.</translation>
    </message>
</context>
<context>
    <name>glisson::LabelDialog</name>
    <message>
        <source>Which label is what?</source>
        <translation>Welches Label ist was?</translation>
    </message>
    <message>
        <source>These labels carry no name Glisson knows. Choose what each one is; nothing is guessed.</source>
        <translation>Diese Labels tragen keinen Namen, den Glisson kennt. Wählen Sie, was jedes ist; geraten wird nichts.</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>Choose a kind for every label first.</source>
        <translation>Wählen Sie zuerst für jedes Label eine Art.</translation>
    </message>
</context>
<context>
    <name>glisson::MainActions</name>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Narrow liver</source>
        <translation>Leber, eng</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Blut</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open files...</source>
        <translation>Dateien ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open &amp;folder...</source>
        <translation>&amp;Ordner öffnen...</translation>
    </message>
    <message>
        <source>Open the sample &amp;patient</source>
        <translation>&amp;Beispielpatient öffnen</translation>
    </message>
    <message>
        <source>&amp;Last cases</source>
        <translation>&amp;Letzte Fälle</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>&amp;Export package...</source>
        <translation>Paket &amp;exportieren...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Structures</source>
        <translation>&amp;Strukturen</translation>
    </message>
    <message>
        <source>&amp;Workspace panel</source>
        <translation>&amp;Arbeitsbereich</translation>
    </message>
    <message>
        <source>&amp;Hide identity</source>
        <translation>&amp;Person verbergen</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>3D seen &amp;from</source>
        <translation>3D gesehen v&amp;on</translation>
    </message>
    <message>
        <source>Anterior (1)</source>
        <translation>Vorn (1)</translation>
    </message>
    <message>
        <source>Left (3)</source>
        <translation>Links (3)</translation>
    </message>
    <message>
        <source>Superior (7)</source>
        <translation>Oben (7)</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>&amp;CT window</source>
        <translation>&amp;CT-Fenster</translation>
    </message>
    <message>
        <source>&amp;Plane</source>
        <translation>&amp;Ebene</translation>
    </message>
    <message>
        <source>&amp;Place plane on the liver</source>
        <translation>Ebene auf die Leber &amp;setzen</translation>
    </message>
    <message>
        <source>Move 1 mm to the &amp;resected side</source>
        <translation>1 mm zur &amp;Resektatseite</translation>
    </message>
    <message>
        <source>Move 1 mm to the re&amp;mnant</source>
        <translation>1 mm zur Rest&amp;seite</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turn ri&amp;ght</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Turn &amp;up</source>
        <translation>Nach &amp;oben drehen</translation>
    </message>
    <message>
        <source>Turn &amp;down</source>
        <translation>Nach &amp;unten drehen</translation>
    </message>
    <message>
        <source>Remo&amp;ve plane</source>
        <translation>Ebene &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;About Glisson</source>
        <translation>&amp;Über Glisson</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>Place a plane first.</source>
        <translation>Setzen Sie zuerst eine Ebene.</translation>
    </message>
</context>
<context>
    <name>glisson::MainWindow</name>
    <message>
        <source>%1 is ready (%2 s).</source>
        <translation>%1 ist fertig (%2 s).</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Exported and verified: %1</source>
        <translation>Exportiert und geprüft: %1</translation>
    </message>
    <message>
        <source>The normal (0, 0, 0) has no direction; enter at least one component.</source>
        <translation>Die Normale (0, 0, 0) hat keine Richtung; geben Sie mindestens eine Komponente ein.</translation>
    </message>
    <message>
        <source>%1 is open in another program: it can be looked at, and changes are kept only with Save as.</source>
        <translation>%1 ist in einem anderen Programm geöffnet: Ansehen geht, Änderungen bleiben nur mit Speichern unter erhalten.</translation>
    </message>
    <message>
        <source>Reading the CT</source>
        <translation>CT wird gelesen</translation>
    </message>
    <message>
        <source>%1 labels</source>
        <translation>%1 Labels</translation>
    </message>
    <message>
        <source>open one</source>
        <translation>öffnen</translation>
    </message>
    <message>
        <source>%1 of %2 made</source>
        <translation>%1 von %2 fertig</translation>
    </message>
    <message>
        <source>plane placed</source>
        <translation>Ebene gesetzt</translation>
    </message>
    <message>
        <source>no plane yet</source>
        <translation>noch keine Ebene</translation>
    </message>
    <message>
        <source>The plane can be placed as soon as the liver&apos;s volumes are computed.</source>
        <translation>Die Ebene lässt sich setzen, sobald die Volumina der Leber berechnet sind.</translation>
    </message>
    <message>
        <source>Open a CT with its segmentation, or a case</source>
        <translation>Eine CT mit ihrer Segmentierung oder einen Fall öffnen</translation>
    </message>
    <message>
        <source>Images and cases (*.glisson *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm)</source>
        <translation>Bilder und Fälle (*.glisson *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a folder that holds a CT and its segmentation</source>
        <translation>Einen Ordner mit einer CT und ihrer Segmentierung öffnen</translation>
    </message>
    <message>
        <source>Save the case</source>
        <translation>Fall speichern</translation>
    </message>
    <message>
        <source>Glisson cases (*.glisson)</source>
        <translation>Glisson-Fälle (*.glisson)</translation>
    </message>
    <message>
        <source>About Glisson</source>
        <translation>Über Glisson</translation>
    </message>
    <message>
        <source>Glisson %1</source>
        <translation>Glisson %1</translation>
    </message>
    <message>
        <source>Planning of liver resections: the parenchyma by Poisson surface reconstruction, vessels and tumours by marching cubes.

Not for clinical use: this is no medical device. Check every number before you rely on it.</source>
        <translation>Planung von Leberresektionen: das Parenchym durch Poisson-Oberflächenrekonstruktion, Gefäße und Tumoren durch Marching Cubes.

Nicht zur klinischen Anwendung: Dies ist kein Medizinprodukt. Prüfen Sie jede Zahl, bevor Sie sich auf sie verlassen.</translation>
    </message>
</context>
<context>
    <name>glisson::MessageBar</name>
    <message>
        <source>Read (%1 more)</source>
        <translation>Gelesen (noch %1)</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Gelesen</translation>
    </message>
</context>
<context>
    <name>glisson::ModelBuilder</name>
    <message>
        <source>%1 could not be reconstructed: %2</source>
        <translation>%1 ließ sich nicht rekonstruieren: %2</translation>
    </message>
</context>
<context>
    <name>glisson::ModelPanel</name>
    <message>
        <source>Reconstruct model</source>
        <translation>Modell rekonstruieren</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>The structures are being reconstructed.</source>
        <translation>Die Strukturen werden rekonstruiert.</translation>
    </message>
    <message>
        <source>Every structure has its surface.</source>
        <translation>Jede Struktur hat ihre Oberfläche.</translation>
    </message>
    <message>
        <source>Makes the surfaces that are missing.</source>
        <translation>Erzeugt die fehlenden Oberflächen.</translation>
    </message>
    <message>
        <source>%1 of %2 structures have a surface.</source>
        <translation>%1 von %2 Strukturen haben eine Oberfläche.</translation>
    </message>
    <message>
        <source>Nothing is loaded.</source>
        <translation>Nichts geladen.</translation>
    </message>
</context>
<context>
    <name>glisson::ModelView</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>resected</source>
        <translation>Resektat</translation>
    </message>
</context>
<context>
    <name>glisson::PlanPanel</name>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>durchtrennt</translation>
    </message>
    <message>
        <source>left</source>
        <translation>belassen</translation>
    </message>
    <message>
        <source>%1 from the cut</source>
        <translation>%1 vom Schnitt</translation>
    </message>
    <message>
        <source>FLR</source>
        <translation>FLR</translation>
    </message>
    <message>
        <source>Future liver remnant: functional liver left, and its share of the functional liver</source>
        <translation>Künftiger Leberrest (future liver remnant): verbleibende funktionelle Leber und ihr Anteil an der funktionellen Leber</translation>
    </message>
    <message>
        <source>RESECTED</source>
        <translation>RESEKTAT</translation>
    </message>
    <message>
        <source>Volume on the resected side, and its share of the whole liver</source>
        <translation>Volumen auf der Resektatseite und sein Anteil an der ganzen Leber</translation>
    </message>
    <message>
        <source>REMNANT</source>
        <translation>REST</translation>
    </message>
    <message>
        <source>Volume left, tumours in it included, and its share of the whole liver</source>
        <translation>Verbleibendes Volumen samt Tumoren darin und sein Anteil an der ganzen Leber</translation>
    </message>
    <message>
        <source>Tumours</source>
        <translation>Tumoren</translation>
    </message>
    <message>
        <source>Vessels crossed</source>
        <translation>Durchtrennte Gefäße</translation>
    </message>
    <message>
        <source>Tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>computing</source>
        <translation>wird berechnet</translation>
    </message>
    <message>
        <source>Liver %1, functional %2, uncertainty of the cut ±%3</source>
        <translation>Leber %1, funktionell %2, Unsicherheit des Schnitts ±%3</translation>
    </message>
    <message>
        <source>This plan has %1 planes: the numbers count all of them, the views show and move the first one only.</source>
        <translation>Dieser Plan hat %1 Ebenen: Die Zahlen zählen alle, die Ansichten zeigen und bewegen nur die erste.</translation>
    </message>
    <message>
        <source>MARGIN</source>
        <translation>ABSTAND</translation>
    </message>
    <message>
        <source>no plane</source>
        <translation>keine Ebene</translation>
    </message>
    <message>
        <source>no tumour</source>
        <translation>kein Tumor</translation>
    </message>
    <message>
        <source>MARGIN %1, %2</source>
        <translation>ABSTAND %1, %2</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>tumour is cut</source>
        <translation>Tumor durchtrennt</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>Out of date until the plane rests</source>
        <translation>Veraltet, bis die Ebene ruht</translation>
    </message>
    <message>
        <source>Vessels crossed: %1</source>
        <translation>Durchtrennte Gefäße: %1</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
    <message>
        <source>The liver&apos;s volumes are being computed.</source>
        <translation>Die Volumina der Leber werden berechnet.</translation>
    </message>
</context>
<context>
    <name>glisson::PlaneEditor</name>
    <message>
        <source>Resection plane</source>
        <translation>Resektionsebene</translation>
    </message>
    <message>
        <source>Place plane on the liver</source>
        <translation>Ebene auf die Leber setzen</translation>
    </message>
    <message>
        <source>Swap sides</source>
        <translation>Seiten tauschen</translation>
    </message>
    <message>
        <source>Remove plane</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>A point of the plane, mm: to the patient&apos;s left, posterior, superior</source>
        <translation>Ein Punkt der Ebene, mm: nach links, hinten, oben vom Patienten aus</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>The direction that points to the resected side; made one long when entered</source>
        <translation>Die Richtung zur Resektatseite; wird nach der Eingabe auf Länge eins gebracht</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Schieben</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Kippen</translation>
    </message>
    <message>
        <source>Move towards the remnant</source>
        <translation>Zum Rest hin schieben</translation>
    </message>
    <message>
        <source>Move towards the resected side</source>
        <translation>Zum Resektat hin schieben</translation>
    </message>
    <message>
        <source>Turn left as seen in the 3D view</source>
        <translation>Nach links drehen, wie in 3D gesehen</translation>
    </message>
    <message>
        <source>Turn right as seen in the 3D view</source>
        <translation>Nach rechts drehen, wie in 3D gesehen</translation>
    </message>
    <message>
        <source>Turn up as seen in the 3D view</source>
        <translation>Nach oben drehen, wie in 3D gesehen</translation>
    </message>
    <message>
        <source>Turn down as seen in the 3D view</source>
        <translation>Nach unten drehen, wie in 3D gesehen</translation>
    </message>
    <message>
        <source>Through the middle of the liver, edge-on as seen in the 3D view (P)</source>
        <translation>Durch die Mitte der Leber, in 3D von der Kante gesehen (P)</translation>
    </message>
    <message>
        <source>Place a plane first.</source>
        <translation>Setzen Sie zuerst eine Ebene.</translation>
    </message>
</context>
<context>
    <name>glisson::ScreenshotTaker</name>
    <message>
        <source>%1 structures could not be reconstructed.</source>
        <translation>%1 Strukturen ließen sich nicht rekonstruieren.</translation>
    </message>
    <message>
        <source>%1 cannot be written; check the folder.</source>
        <translation>%1 lässt sich nicht schreiben; prüfen Sie den Ordner.</translation>
    </message>
</context>
<context>
    <name>glisson::SliceView</name>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>%1 mm
slice %2 of %3</source>
        <translation>%1 mm
Schicht %2 von %3</translation>
    </message>
    <message>
        <source>W %1
L %2</source>
        <translation>W %1
L %2</translation>
    </message>
    <message>
        <source>Axial slices</source>
        <translation>Axiale Schichten</translation>
    </message>
    <message>
        <source>Coronal slices</source>
        <translation>Koronale Schichten</translation>
    </message>
    <message>
        <source>Sagittal slices</source>
        <translation>Sagittale Schichten</translation>
    </message>
</context>
<context>
    <name>glisson::StartPage</name>
    <message>
        <source>Glisson</source>
        <translation>Glisson</translation>
    </message>
    <message>
        <source>Planning of liver resections. Not for clinical use.</source>
        <translation>Planung von Leberresektionen. Nicht zur klinischen Anwendung.</translation>
    </message>
    <message>
        <source>Open the sample patient</source>
        <translation>Beispielpatient öffnen</translation>
    </message>
    <message>
        <source>Open files...</source>
        <translation>Dateien öffnen...</translation>
    </message>
    <message>
        <source>Or drop here: a CT (DICOM folder, NIfTI, NRRD, MetaImage) together with its segmentation, or a .glisson case.</source>
        <translation>Oder hier ablegen: eine CT (DICOM-Ordner, NIfTI, NRRD, MetaImage) zusammen mit ihrer Segmentierung oder einen Fall (.glisson).</translation>
    </message>
    <message>
        <source>1. Open a CT and its segmentation: the model is reconstructed by itself.
2. Place the resection plane on the liver and move it: volumes and margins follow.
3. Export the package for navigation.</source>
        <translation>1. CT und Segmentierung öffnen: Das Modell entsteht von selbst.
2. Resektionsebene auf die Leber setzen und bewegen: Volumina und Abstände folgen.
3. Das Paket für die Navigation exportieren.</translation>
    </message>
    <message>
        <source>Last cases</source>
        <translation>Letzte Fälle</translation>
    </message>
</context>
<context>
    <name>glisson::StructureList</name>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Volume of the labelled voxels</source>
        <translation>Volumen der markierten Voxel</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Colour...</source>
        <translation>Farbe...</translation>
    </message>
    <message>
        <source>Select a structure in the list first.</source>
        <translation>Wählen Sie zuerst eine Struktur in der Liste.</translation>
    </message>
    <message>
        <source>No surface yet.</source>
        <translation>Noch keine Oberfläche.</translation>
    </message>
    <message>
        <source>Surface %1, voxels %2 (%3), %4 triangles</source>
        <translation>Oberfläche %1, Voxel %2 (%3), %4 Dreiecke</translation>
    </message>
    <message>
        <source>Defect: %1</source>
        <translation>Mangel: %1</translation>
    </message>
    <message>
        <source>Deviation: %1</source>
        <translation>Abweichung: %1</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Hinweis: %1</translation>
    </message>
</context>
<context>
    <name>glisson::TitleLine</name>
    <message>
        <source>Hide identity</source>
        <translation>Person verbergen</translation>
    </message>
    <message>
        <source>Hides the person for pictures; the case&apos;s code stays</source>
        <translation>Verbirgt die Person für Bilder; der Code des Falls bleibt</translation>
    </message>
    <message>
        <source>No case</source>
        <translation>Kein Fall</translation>
    </message>
    <message>
        <source>identity hidden</source>
        <translation>Person verborgen</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>id %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geb. %1</translation>
    </message>
    <message>
        <source>CT of %1</source>
        <translation>CT vom %1</translation>
    </message>
    <message>
        <source>CT is %1 days old</source>
        <translation>CT ist %1 Tage alt</translation>
    </message>
</context>
<context>
    <name>glisson::WorkspaceBar</name>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Open a case first.</source>
        <translation>Öffnen Sie zuerst einen Fall.</translation>
    </message>
</context>
</TS>
